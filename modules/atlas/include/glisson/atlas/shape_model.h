// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/geometry/mesh.h"

/// @file
/// Generalised Procrustes analysis and principal components of shapes whose points correspond (paper 2.2.1,
/// eqs. 9 to 13 as the README corrects them). Pure functions, safe from any thread.

namespace glisson::atlas {

/// x -> scale * rotation * x + translation.
struct Similarity {
  double scale = 1.0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< metres

  /// Every row of an N x 3 array, metres.
  Points apply(const Points& points) const;
  /// @pre the scale is not zero.
  Similarity inverse() const;
};
/// The similarity that carries `source` onto `target` best in the weighted least-squares sense: R = V U^T of
/// the SVD of P Pbar^T with det R = +1, s = tr(R P Pbar^T) / |P|^2 (never a reflection).
/// @param weights one a row, or empty. @pre the same number of rows, three at least.
Similarity fit_similarity(const Points& source, const Points& target, const Eigen::VectorXd& weights = {});

/// Root of the mean squared distance from the centre of the points, metres.
double size_of(const Points& points);

/// Shapes aligned with their mean, and the mean.
struct Procrustes {
  Points mean;                               ///< metres
  std::vector<Similarity> mean_from_member;  ///< one a member
  int iterations = 0;
};
/// Aligns shapes in a common frame. The mean's size is the weighted geometric mean of the members' sizes, its
/// orientation and place those that fit `gauge` best: so neither the members' order nor their motion matters.
/// @param weights one a member, > 0. @pre two members at least, all with as many rows as `gauge`.
Procrustes align(const std::vector<Points>& members, const std::vector<double>& weights, const Points& gauge);

/// mean + sum_k b_k mode_k, with b_k of variance `variances[k]`.
struct ShapeModel {
  Points mean;                ///< M x 3, metres
  Eigen::MatrixXd modes;      ///< 3M x K, orthonormal columns; rows x0 y0 z0 x1 ...
  Eigen::VectorXd variances;  ///< of the coefficients, m2, largest first
  double total_variance = 0;  ///< m2, of all modes that there are

  int mode_count() const { return static_cast<int>(variances.size()); }
  /// @param b one a mode, metres
  Points instance(const Eigen::VectorXd& b) const;
  /// Of a shape in the mean's frame, by projection.
  Eigen::VectorXd coefficients(const Points& shape) const;
};
/// Weighted principal components of aligned shapes, as many as explain `share` of the variance. A mode's sign
/// is such that its largest entry is positive.
/// @pre as many weights as shapes; share in (0, 1]
ShapeModel shape_model(const std::vector<Points>& aligned, const std::vector<double>& weights,
                       double share = 0.9);

}  // namespace glisson::atlas
