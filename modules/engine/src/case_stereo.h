// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "glisson/engine/case_state.h"

/// @file
/// What the stereo laparoscope has brought to a case, as files: the pair of pictures, the labelled cloud and
/// the points of the whole pair that it was made of.

namespace glisson::engine {

/// frame/left.png, frame/right.png, frame/mask.png. @return the part's entry in case.json.
nlohmann::json write_frame(const std::filesystem::path& folder, const StereoInput& input);
StereoInput read_frame(const std::filesystem::path& folder, const nlohmann::json& entry);

/// points/whole.ply: the points, left camera's frame, mm, with normals and standard deviation;
/// points/points.json: of which pair they are, how they were made, their covariance (mm2), figures and
/// density.
/// @pre `points` has a cloud.
void write_points(const std::filesystem::path& folder, const CaseState& state, const PairPoints& points);
/// @param state with the frame and the rig that were saved beside the points: they belong to these again.
/// @throws InputError, FileError naming the file and the field: missing, malformed, of other pictures.
std::shared_ptr<const PairPoints> read_points(const std::filesystem::path& folder, const CaseState& state);

/// Whether two sets of points are the same but for what files round (1e-6 of a value).
bool same_points(const PairPoints& a, const PairPoints& b);

}  // namespace glisson::engine
