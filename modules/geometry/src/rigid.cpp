// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/rigid.h"

#include <Eigen/SVD>

namespace glisson {

RigidMotion fit_rigid_motion(const Points& source, const Points& target, const Eigen::VectorXd& weights) {
  const Eigen::VectorXd w =
      weights.size() == source.rows() ? weights : Eigen::VectorXd::Ones(source.rows()).eval();
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
