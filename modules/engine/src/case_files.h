// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "glisson/engine/part.h"
#include "glisson/patient/patient_model.h"

/// @file
/// The single files of a case that no other module reads or writes.

namespace glisson::engine {

/// Vessel trees as VTP lines, LPS mm: point data "radius_mm" and "tree", field data "structures" and "roots".
void write_vessels(const std::filesystem::path& path, const std::vector<VesselTree>& trees);
std::vector<VesselTree> read_vessels(const std::filesystem::path& path);

/// N x 3 points (metres here, mm there) to and from a JSON array of triples.
nlohmann::json points_to_json(const Points& points);
/// @throws InputError naming file and field.
Points points_from_json(const nlohmann::json& array, const std::string& file, const std::string& field);

/// Whether two sets of points are the same but for what millimetres in text or floats round: a micrometre is
/// lost to nobody.
bool same_points(const Points& a, const Points& b);

/// Reads what can be made again. @param code the note about it ("case.cloud_lost").
/// @return false when it could not be read and that was told (CaseFolder::lost). @throws what `read` throws
/// where nobody is to be told.
bool or_lost(const CaseFolder& folder, const char* code, const std::function<void()>& read);

}  // namespace glisson::engine
