// SPDX-License-Identifier: GPL-3.0-or-later
#include "holding.h"

#include <Eigen/Dense>

namespace glisson::guidance {
namespace {

/// Of the breath, one deviation: metres and radians (Clifford et al. 2002 and others: livers go 10 to 25 mm
/// up and down and turn by few degrees).
constexpr double kBreath = 8e-3, kBreathTurns = 0.05;
/// Of the scope's way, what the scenery tells wrong: a look of stereo errs by 5 % at the wall's depth (0.3
/// pixels at 17 cm, 5 mm between the cameras), all places that were first seen from one place alike, and a
/// fast hand sees few of them for long: 12 of 60 mm were found in the theatre.
constexpr double kOfWay = 0.2;
/// Deviations. No breath and no tool takes most of the organ so far: what is beside it is no scenery then.
constexpr double kFarthest = 3.0;
/// By how much tissue that goes along differs from a rigid motion, metres.
constexpr double kElastic = 2e-3;
/// Neighbouring points err alike: all of them tell as much as so many independent ones.
constexpr double kIndependent = 10.0;

}  // namespace

RigidMotion common_to_most(const Points& rest, const std::vector<FollowedPoint>& points,
                           const RigidMotion& start, const std::optional<ExpectedMotion>& expected) {
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
    if (expected) {
      const RigidMotion& there = expected->motion;
      const double of_turns = 1.0 / (expected->turns * expected->turns);
      const double of_way = 1.0 / (expected->deviation * expected->deviation);
      const Eigen::AngleAxisd turned(motion.rotation * there.rotation.transpose());
      hessian.diagonal() << Eigen::Vector3d::Constant(of_turns), Eigen::Vector3d::Constant(of_way);
      gradient.head<3>() = -of_turns * turned.angle() * turned.axis();
      gradient.tail<3>() = of_way * (there.rotation * middle + there.translation - centre);
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

void Holding::begin_scenery() {
  scene_before_ = from_start_;
  way_ = 0.0;
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
  const RigidMotion before = from_start_, start = organ.after(before);
  std::optional<ExpectedMotion> expected;
  if (const auto scene = scenery_.follow(follower, organ, middle)) {
    way_ += (scene->rotation * middle + scene->translation - middle).norm();
    const double grown = std::hypot(1.0, kOfWay * way_ / kBreath);
    expected = ExpectedMotion{scenery_.camera_from_scene().after(scene_before_), grown * kBreath,
                              grown * kBreathTurns};
    const double apart = (expected->motion.apply(rest) - start.apply(rest)).rowwise().norm().mean();
    if (apart > kFarthest * expected->deviation) expected.reset();
  }
  from_start_ = common_to_most(rest, points, start, expected);
  // How the scope moves meanwhile, only the organ tells: from then on scenery is what is seen beside it.
  if (!expected) begin_scenery();
  return from_start_.after(before.inverse());
}

}  // namespace glisson::guidance
