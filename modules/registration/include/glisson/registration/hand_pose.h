// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"
#include "glisson/geometry/rigid.h"

/// @file
/// A pose that a hand sets: the model is held before the picture and moved by the mouse. Each step keeps the
/// organ's middle (its centroid, CT frame, metres) where nothing else is said.

namespace glisson::registration {

/// Upright before the camera, seen from the patient's front, with the organ's middle at a place of the
/// camera's frame.
CameraFromCt upright_before(const Eigen::Vector3d& middle_in_ct, const Eigen::Vector3d& middle_in_camera);

/// The middle goes along with the mouse, as deep as it is: what lay under `from` there lies under `to`.
/// Pixels of the left view. A middle behind the camera stays.
CameraFromCt dragged(const CameraFromCt& pose, const Eigen::Vector3d& middle_in_ct, const Camera& camera,
                     const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// Turned about its middle by a rotation vector of the camera's frame (axis times radians).
CameraFromCt turned(const CameraFromCt& pose, const Eigen::Vector3d& middle_in_ct,
                    const Eigen::Vector3d& rotation);

/// The middle moves along its ray: its distance is multiplied. @pre factor > 0.
CameraFromCt at_distance(const CameraFromCt& pose, const Eigen::Vector3d& middle_in_ct, double factor);

}  // namespace glisson::registration
