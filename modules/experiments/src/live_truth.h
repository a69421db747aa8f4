// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/geometry/camera.h"
#include "live_faults.h"

namespace glisson::experiments {

/// Metres: the error where the organ is not in the picture at all.
inline constexpr double kNowhere = 0.1;

/// Whether what the laparoscope shows is not this patient's organ: any overlay on it is wrong.
bool shows_another_organ(const LiveFault& fault);

/// How far what is drawn of a place lies from that place of the organ in the picture that is shown, metres.
/// Where the pictures are not those that the program takes them for, its place in the camera's frame may be
/// right and what is drawn wrong: as the eye sees it at the true depth, through the true lens.
/// @param rig the true one. @param found, truth left camera's frame, metres. @pre !shows_another_organ().
double drawn_error(const LiveFault& fault, const StereoRig& rig, int frame, const Eigen::Vector3d& found,
                   const Eigen::Vector3d& truth);

}  // namespace glisson::experiments
