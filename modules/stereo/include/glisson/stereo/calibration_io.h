// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/geometry/camera.h"

namespace glisson::stereo {

/// Reads an OpenCV YAML (cm, mm or m by `unit`): M1 D1 M2 D2 R T image_width image_height unit, x_right = R
/// x_left + T.
/// @throws FileError; InputError naming the field: missing, wrong shape, R not a rotation, no baseline or one
///   that no laparoscope has (1 to 30 mm: the unit is wrong then), unit unknown, principal point outside the
///   image, left and right swapped (a right camera to the left of the left one).
StereoRig read_calibration(const std::filesystem::path& path);
/// Writes the same in millimetres. Atomic.
void write_calibration(const std::filesystem::path& path, const StereoRig& rig);

}  // namespace glisson::stereo
