// SPDX-License-Identifier: GPL-3.0-or-later
#include "holding.h"

#include <Eigen/Dense>

namespace glisson::guidance {
namespace {

/// Of the breath, one deviation: metres and radians (Clifford et al. 2002 and others: livers go 10 to 25 mm
/// up and down and turn by few degrees).
constexpr double kBreath = 8e-3, kBreathTurns = 0.05;
/// By how much tissue that goes along differs from a rigid motion, metres.
constexpr double kElastic = 2e-3;
/// Neighbouring points err alike: all of them tell as much as so many independent ones.
constexpr double kIndependent = 10.0;

}  // namespace

RigidMotion common_to_most(const Points& rest, const std::vector<FollowedPoint>& points,
                           const RigidMotion& start, bool is_known) {
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  using Matrix6d = Eigen::Matrix<double, 6, 6>;
  const auto n = static_cast<double>(points.size());
  const Eigen::Vector3d middle = rest.colwise().mean().transpose();
  RigidMotion motion = start;
  for (const double scale : {16e-3, 8e-3, 4e-3, kElastic, kElastic, kElastic}) {
    // Of a turn about the middle and a way.
    Matrix6d hessian = Matrix6d::Zero();
    Vector6d gradient = Vector6d::Zero();
    const Eigen::Vector3d centre = motion.rotation * middle + motion.translation;
    if (is_known) {
      const Eigen::AngleAxisd turned(motion.rotation * start.rotation.transpose());
      hessian.diagonal() << Eigen::Vector3d::Constant(1.0 / (kBreathTurns * kBreathTurns)),
          Eigen::Vector3d::Constant(1.0 / (kBreath * kBreath));
      gradient.head<3>() = -turned.angle() * turned.axis() / (kBreathTurns * kBreathTurns);
      gradient.tail<3>() = (start.rotation * middle + start.translation - centre) / (kBreath * kBreath);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d there =
          motion.rotation * rest.row(static_cast<Eigen::Index>(i)).transpose() + motion.translation;
      const Eigen::Vector3d gap = points[i].p_in_camera - there;
      const Eigen::Matrix3d information = points[i].information;
      const double square = scale * scale, share = square / (square + gap.dot(information * gap)),
                   weight = share * share * std::min(1.0, kIndependent / n) / (kElastic * kElastic);
      const Eigen::Vector3d arm = there - centre;
      Eigen::Matrix<double, 3, 6> moves;
      moves << 0.0, arm.z(), -arm.y(), 1.0, 0.0, 0.0, -arm.z(), 0.0, arm.x(), 0.0, 1.0, 0.0, arm.y(),
          -arm.x(), 0.0, 0.0, 0.0, 1.0;
      hessian += weight * moves.transpose() * information * moves;
      gradient += weight * moves.transpose() * information * gap;
    }
    const Vector6d step = hessian.ldlt().solve(gradient);
    if (!step.allFinite()) return start;
    const Eigen::Matrix3d turn = rotation_by(step.head<3>());
    motion.translation = turn * (motion.translation - centre) + centre + step.tail<3>();
    motion.rotation = turn * motion.rotation;
  }
  return motion;
}

Holding::Holding(const PatientModel& model, const Points& shape, const StereoRig& rig)
    : rest_(model), scenery_(rig) {
  rest_.move(shape);
}

void Holding::found(const RigidMotion& motion) {
  from_start_ = motion.after(from_start_);
  scene_before_ = from_start_;
  scene_ = {};
  scenery_.begin();
}

RigidMotion Holding::follow(const StereoFollower& follower, const AnchoredPoints& anchors,
                            const registration::MovingSurface& now) {
  const std::vector<FollowedPoint>& points = follower.points();
  Points rest(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    rest.row(static_cast<Eigen::Index>(i)) = anchors.anchor(points[i].id).place(rest_).transpose();
    middle += points[i].p_in_camera / static_cast<double>(points.size());
  }
  const RigidMotion organ = anchors.common_motion(points, now);
  const auto scene = scenery_.follow(follower, organ, middle);
  scene_ = scene.value_or(organ).after(scene_);
  const RigidMotion start = scene ? scene_.after(scene_before_) : organ.after(from_start_);
  const RigidMotion before = from_start_;
  from_start_ = common_to_most(rest, points, start, scene.has_value());
  return from_start_.after(before.inverse());
}

}  // namespace glisson::guidance
