// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "glisson/core/frames.h"
#include "glisson/geometry/mesh.h"

namespace glisson {

/// A rotation and a translation (metres) from one frame to another: p_in_target = R p_in_source + t. Named
/// target_from_source, so that neighbours must match: camera_from_ct * p_in_ct.
template <class Target, class Source>
struct Rigid {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Point<Target> operator*(const Point<Source>& p) const {
    return Point<Target>(rotation * p.xyz + translation);
  }

  template <class Origin>
  Rigid<Target, Origin> operator*(const Rigid<Source, Origin>& inner) const {
    return {rotation * inner.rotation, rotation * inner.translation + translation};
  }

  Rigid<Source, Target> inverse() const {
    return {rotation.transpose(), -(rotation.transpose() * translation)};
  }

  /// Every row of an N x 3 array of points in Source, into Target.
  Points apply(const Points& points) const {
    return (points * rotation.transpose()).rowwise() + translation.transpose();
  }

  /// Homogeneous 4 x 4, metres.
  Eigen::Matrix4d matrix() const {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = rotation;
    m.topRightCorner<3, 1>() = translation;
    return m;
  }
  static Rigid from_matrix(const Eigen::Matrix4d& m) {
    return {m.topLeftCorner<3, 3>(), m.topRightCorner<3, 1>()};
  }
};

using CameraFromCt = Rigid<CameraFrame, CtFrame>;

/// About a rotation vector (its length: radians; none: the identity).
inline Eigen::Matrix3d rotation_by(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix()
                     : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

/// A Rigid whose frames are not said.
struct RigidMotion {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
};
/// What fit_rigid() computes; compiled once.
RigidMotion fit_rigid_motion(const Points& source, const Points& target, const Eigen::VectorXd& weights);

/// The rotation (det = +1) and translation that carry `source` onto `target` best in the weighted
/// least-squares sense (Arun 1987 with Umeyama's sign). Rows correspond; weights may be empty.
/// @pre both have the same number of rows, three at least.
template <class Target, class Source>
Rigid<Target, Source> fit_rigid(const Points& source, const Points& target,
                                const Eigen::VectorXd& weights = {}) {
  const RigidMotion motion = fit_rigid_motion(source, target, weights);
  return {motion.rotation, motion.translation};
}

}  // namespace glisson
