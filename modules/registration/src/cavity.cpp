// SPDX-License-Identifier: GPL-3.0-or-later
#include "cavity.h"

#include <cmath>

namespace glisson::registration {
namespace {

constexpr double kTurned = 0.342;  ///< sine of 20 degrees

}  // namespace

Cavity::Cavity(const PatientModel& model) : middle_(model.mesh.vertices.colwise().mean().transpose()) {}

bool Cavity::holds(const Point<CtFrame>& eye) const {
  static const Eigen::Vector3d kForwardsAndDown = Eigen::Vector3d(0.0, -1.0, -1.0).normalized();
  const Eigen::Vector3d away = eye.xyz - middle_;
  return away.dot(kForwardsAndDown) >= -kTurned * away.norm();
}

bool Cavity::holds(const CameraFromCt& pose, const LabelledCloud& cloud) const {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  for (int i = 0; i < cloud.size(); ++i) eye += cloud.eye(i) / cloud.size();
  return holds(pose.inverse() * Point<CameraFrame>(eye));
}

}  // namespace glisson::registration
