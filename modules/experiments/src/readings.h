// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "glisson/atlas/member.h"
#include "glisson/core/json_file.h"

namespace glisson::experiments {

/// What one reader marked on a real liver, from slices and renderings of its labels. CT frame, metres.
struct Reading {
  PointsIn<CtFrame> notch;          ///< 1 x 3: where the fissure of the round ligament meets the margin
  PointsIn<CtFrame> again;          ///< the notch marked once more, some time later; may be empty
  PointsIn<CtFrame> falciform;      ///< from the notch over the dome to the vena cava's front
  PointsIn<CtFrame> margin;         ///< from the right lobe's tip to the left lobe's end
  PointsIn<CtFrame> umbilical_tip;  ///< 1 x 3: the end of the portal vein's umbilical part; may be empty
};
/// Two readings of each liver, by its name.
using Readings = std::map<std::string, std::vector<Reading>>;

/// A file "glisson-readings", LPS millimetres. @throws FileError, InputError naming file, liver and field.
Readings read_readings(const std::filesystem::path& path);

/// Notch, falciform line and margin: the middle between what the readers marked.
std::map<atlas::Structure, PointsIn<CtFrame>> truth_of(const std::vector<Reading>& readings);

/// How far readers lie apart (mean and worst over livers, mm): "readings_umbilical_notch_mean_mm", ...; and
/// what lies between a reader's notch and the same reader's later one ("readings_again_...").
Figures apart(const Readings& readings);

}  // namespace glisson::experiments
