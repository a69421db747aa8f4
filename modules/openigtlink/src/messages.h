// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "glisson/geometry/mesh.h"
#include "glisson/patient/lesion_verdict.h"

/// @file
/// Messages as bytes, header included. Seconds are since 1970.

namespace glisson::openigtlink {

/// Longest name of a device.
inline constexpr std::size_t kLongestName = 20;

/// @param pose_mm homogeneous; its translation in millimetres.
std::string transform_message(const std::string& name, double seconds, const Eigen::Matrix4d& pose_mm);
/// OK for a valid level, otherwise "not ready" with subcode 1 (degraded) or 2 (withdrawn): a peer that knows
/// the code alone does not take less than everything for all's well.
std::string status_message(const std::string& name, double seconds, Level level, const std::string& text);
std::string string_message(const std::string& name, double seconds, const std::string& text);
/// @param vertices any one frame, metres; they leave in millimetres. Empty ones make a message that clears.
std::string poly_data_message(const std::string& name, double seconds, const Points& vertices,
                              const Triangles& triangles);

}  // namespace glisson::openigtlink
