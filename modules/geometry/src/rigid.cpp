// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/rigid.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include "glisson/core/error.h"

namespace glisson {

RigidMotion RigidMotion::after(const RigidMotion& inner) const {
  return {rotation * inner.rotation, rotation * inner.translation + translation};
}

RigidMotion RigidMotion::inverse() const {
  return {rotation.transpose(), -(rotation.transpose() * translation)};
}

Points RigidMotion::apply(const Points& points) const {
  return (points * rotation.transpose()).rowwise() + translation.transpose();
}

Eigen::Matrix4d RigidMotion::matrix() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = rotation;
  m.topRightCorner<3, 1>() = translation;
  return m;
}

RigidMotion RigidMotion::from_matrix(const Eigen::Matrix4d& m, const std::string& where) {
  constexpr double kRounded = 1e-3;
  const RigidMotion motion{m.topLeftCorner<3, 3>(), m.topRightCorner<3, 1>()};
  const Eigen::Matrix3d& r = motion.rotation;
  if (!m.allFinite() || (r * r.transpose() - Eigen::Matrix3d::Identity()).norm() > kRounded ||
      r.determinant() < 0.0)
    throw InputError(where, "matrix", "its upper left 3 x 3 block is not a rotation",
                     "Take out scale and mirroring");
  return motion;
}

Eigen::Matrix3d rotation_by(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix()
                     : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

RigidMotion fit_rigid_motion(const Points& source, const Points& target, const Eigen::VectorXd& weights) {
  require(source.rows() == target.rows(), "points that are fitted to each other are as many on both sides");
  require(weights.size() == 0 || weights.size() == source.rows(),
          "points that are fitted have a weight each");
  const Eigen::VectorXd w = weights.size() > 0 ? weights : Eigen::VectorXd::Ones(source.rows()).eval();
  const double total = w.sum();
  const Eigen::Vector3d source_mean = (w.transpose() * source).transpose() / total;
  const Eigen::Vector3d target_mean = (w.transpose() * target).transpose() / total;
  const Eigen::Matrix3d covariance = (target.rowwise() - target_mean.transpose()).transpose() *
                                     w.asDiagonal() * (source.rowwise() - source_mean.transpose());
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1.0 : 1.0;
  RigidMotion result;
  result.rotation = svd.matrixU() * sign * svd.matrixV().transpose();
  result.translation = target_mean - result.rotation * source_mean;
  return result;
}

}  // namespace glisson
