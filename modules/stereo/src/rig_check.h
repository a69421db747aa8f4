// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/geometry/camera.h"

namespace glisson::stereo {

/// The lenses of a laparoscope lie in a tube of 10 to 12 mm; robots and heads for open surgery reach further.
constexpr double kSmallestBaseline = 1e-3, kLargestBaseline = 30e-3;

/// Where the right camera is in the left one's frame, metres.
inline Eigen::Vector3d right_in_left(const StereoRig& rig) {
  return -(rig.right_from_left.rotation.transpose() * rig.right_from_left.translation);
}

/// Four significant digits, for messages.
std::string number_text(double value);

/// @throws InputError "file: T: ..." no baseline, one that no laparoscope has, right camera left of the left
///   one.
void check_rig(const std::string& file, const StereoRig& rig);

/// @throws InputError "file: field: ..." no camera matrix, or a principal point outside the image.
void check_camera(const std::string& file, const std::string& field, const Camera& camera);

/// The rotation next to a matrix that was rounded to a few digits in its file.
/// @throws InputError "file: field: ..." it is not one.
Eigen::Matrix3d checked_rotation(const std::string& file, const std::string& field,
                                 const Eigen::Matrix3d& matrix);

}  // namespace glisson::stereo
