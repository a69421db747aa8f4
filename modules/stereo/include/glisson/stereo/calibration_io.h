// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/units.h"
#include "glisson/geometry/camera.h"
#include "glisson/stereo/source.h"

namespace glisson::stereo {

/// Reads an OpenCV YAML (cm, mm or m by `unit`): M1 D1 M2 D2 R T image_width image_height unit, x_right = R
/// x_left + T.
/// @throws FileError; InputError naming the field: missing, wrong shape, R not a rotation, no baseline or one
///   that no laparoscope has (1 to 30 mm: the unit is wrong then), unit unknown, principal point outside the
///   image, left and right swapped (a right camera to the left of the left one), a matrix that is transposed
///   or has a skew that moves a pixel by more than 0.1 px (a smaller one is left out), tangential terms that
///   no lens has (k3 in their place).
StereoRig read_calibration(const std::filesystem::path& path);
/// Writes the same in millimetres. Atomic.
void write_calibration(const std::filesystem::path& path, const StereoRig& rig);

/// Reads a folder of plain text, as others write it: for each side a file named like
/// "calib.left.intrinsic.txt" (3x3) and "calib.left.distortion.txt" (4 or 5 terms k1 k2 p1 p2 k3), and one
/// 3x4 or 4x4 transform named like "calib.l2r.txt" (x_right = R x_left + T) or "calib.r2l.txt" (the inverse).
/// Where the name does not say which way it maps, the right camera is taken to be right of the left one.
/// @param width, height of the pictures, which these files do not tell, pixels.
/// @param unit of the transform's translation.
/// @throws FileError; InputError naming the file: missing, two of one kind, wrong shape or what
///   read_calibration() refuses.
StereoRig read_text_calibration(const std::filesystem::path& folder, int width, int height,
                                LengthUnit unit = LengthUnit::millimetre);
/// Whether a calibration is one of plain text (a folder), which does not tell the pictures' size.
bool is_text_calibration(const std::filesystem::path& path);
/// The calibration of pictures, from a file of read_calibration() or a folder of read_text_calibration().
/// Scopes are calibrated on whole views: where the pictures were cut out of them, so is what is of their
/// size.
/// @param width, height of the pictures, pixels; 0: not known. @param cut how they were cut; empty: they were
/// not.
/// @throws as those two and cropped().
StereoRig read_calibration_for(const std::filesystem::path& path, int width, int height,
                               const std::optional<Cut>& cut);
/// What a calibration leaves open, as codes with their values: "calibration.left_lens_turns_back 27" (and
/// right_): so many per cent of the picture, from the edges on, have no ray, because the distortion's
/// polynomial turns back before.
std::vector<std::string> calibration_doubts(const StereoRig& rig);

}  // namespace glisson::stereo
