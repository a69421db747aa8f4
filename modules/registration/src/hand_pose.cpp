// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/hand_pose.h"

#include <Eigen/Geometry>

#include "glisson/core/error.h"

namespace glisson::registration {
namespace {

/// This rotation, with the middle at this place.
CameraFromCt with_middle(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& middle_in_ct,
                         const Eigen::Vector3d& middle_in_camera) {
  return {rotation, middle_in_camera - rotation * middle_in_ct};
}

Eigen::Vector3d middle_of(const CameraFromCt& pose, const Eigen::Vector3d& middle_in_ct) {
  return pose.rotation * middle_in_ct + pose.translation;
}

}  // namespace

CameraFromCt upright_before(const Eigen::Vector3d& middle_in_ct, const Eigen::Vector3d& middle_in_camera) {
  // From LPS to right, down, forwards: the patient's left is on the right, the feet are down.
  Eigen::Matrix3d rotation;
  rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return with_middle(rotation, middle_in_ct, middle_in_camera);
}

CameraFromCt dragged(const CameraFromCt& pose, const Eigen::Vector3d& middle_in_ct, const Camera& camera,
                     const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector3d middle = middle_of(pose, middle_in_ct);
  if (middle.z() <= 0.0) return pose;
  const auto at_depth = [&](const Eigen::Vector2d& pixel) -> Eigen::Vector3d {
    const Eigen::Vector3d ray = camera.ray(pixel);
    return ray * (middle.z() / ray.z());
  };
  return with_middle(pose.rotation, middle_in_ct, middle + at_depth(to) - at_depth(from));
}

CameraFromCt turned(const CameraFromCt& pose, const Eigen::Vector3d& middle_in_ct,
                    const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) return pose;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
  return with_middle(turn * pose.rotation, middle_in_ct, middle_of(pose, middle_in_ct));
}

CameraFromCt at_distance(const CameraFromCt& pose, const Eigen::Vector3d& middle_in_ct, double factor) {
  require(factor > 0.0, "a distance is multiplied by more than nothing");
  return with_middle(pose.rotation, middle_in_ct, factor * middle_of(pose, middle_in_ct));
}

}  // namespace glisson::registration
