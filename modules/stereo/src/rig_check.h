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

/// The camera without its skew (row 1, column 2), which the following of points and the finding of places
/// again (OpenCV) do not know: a camera has none anywhere in the program.
/// @throws InputError "file: field: ..." a skew that moves a pixel of the picture by more than 0.1 pixels.
Camera without_skew(const std::string& file, const std::string& field, Camera camera);

/// @throws InputError "file: field: ..." tangential terms that move pixels by more than a hundredth of the
///   picture's width and by half of what the radial ones do. Those of a lens come from its being off its
///   axis or aslant (Brown 1966), and are small beside them; k3 in their place is not.
void check_distortion(const std::string& file, const std::string& field, const Camera& camera);

/// Share of the picture, from 0 to 1, to which the lens maps nothing (Camera::maps): the polynomial turns
/// back before it comes there.
double share_without_rays(const Camera& camera);

/// The rotation next to a matrix that was rounded to a few digits in its file.
/// @throws InputError "file: field: ..." it is not one.
Eigen::Matrix3d checked_rotation(const std::string& file, const std::string& field,
                                 const Eigen::Matrix3d& matrix);

}  // namespace glisson::stereo
