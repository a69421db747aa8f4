// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "glisson/core/frames.h"
#include "glisson/geometry/mesh.h"

namespace glisson {

/// A Rigid whose frames are not said. What it and Rigid compute is compiled once: some five hundred units
/// read this header, and each would instantiate the expressions again.
struct RigidMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  RigidMotion after(const RigidMotion& inner) const;  ///< what first moves by `inner`
  /// With R^T for R^-1: right only if `rotation` is a rotation.
  RigidMotion inverse() const;
  /// Every row p of an N x 3 array to R p + t, metres.
  Points apply(const Points& points) const;
  /// Homogeneous 4 x 4 with the translation in metres.
  Eigen::Matrix4d matrix() const;
  /// Of a matrix from a file. The last row is not read. @param where the file, for the error.
  /// @throws InputError its field "matrix": a number that is not finite, scale, shear or reflection.
  static RigidMotion from_matrix(const Eigen::Matrix4d& m, const std::string& where);
};

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
    return Rigid<Target, Origin>::of(motion().after(inner.motion()));
  }

  Rigid<Source, Target> inverse() const { return Rigid<Source, Target>::of(motion().inverse()); }

  /// @param points N x 3, metres, in Source. @return the same rows in Target.
  Points apply(const Points& points) const { return motion().apply(points); }

  /// Homogeneous 4 x 4, metres.
  Eigen::Matrix4d matrix() const { return motion().matrix(); }
  /// As RigidMotion::from_matrix(), and throws as it.
  static Rigid from_matrix(const Eigen::Matrix4d& m, const std::string& where) {
    return of(RigidMotion::from_matrix(m, where));
  }

  RigidMotion motion() const { return {rotation, translation}; }
  static Rigid of(const RigidMotion& motion) { return {motion.rotation, motion.translation}; }
};

using CameraFromCt = Rigid<CameraFrame, CtFrame>;

/// About a rotation vector (its length: radians; none: the identity).
Eigen::Matrix3d rotation_by(const Eigen::Vector3d& vector);

/// What fit_rigid() computes; compiled once.
RigidMotion fit_rigid_motion(const Points& source, const Points& target, const Eigen::VectorXd& weights);

/// The rotation (det = +1) and translation that carry `source` onto `target` best in the weighted
/// least-squares sense (Arun 1987 with Umeyama's sign). Rows correspond; weights may be empty.
/// @pre both have the same number of rows, three at least.
template <class Target, class Source>
Rigid<Target, Source> fit_rigid(const Points& source, const Points& target,
                                const Eigen::VectorXd& weights = {}) {
  return Rigid<Target, Source>::of(fit_rigid_motion(source, target, weights));
}

}  // namespace glisson
