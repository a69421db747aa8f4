// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/fem/elastic_body.h"

namespace glisson::fem {

/// One of the laws with its numbers: Young's modulus 1 Pa.
struct LawConstants {
  BodyLaw law;
  double mu, lambda;
  explicit LawConstants(const BodyMaterial& material);
};

/// Energy density, J/m3.
double density(const LawConstants& law, const Eigen::Matrix3d& f);
/// The same and its derivative by F.
double density(const LawConstants& law, const Eigen::Matrix3d& f, Eigen::Matrix3d& stress);

/// The density's second derivative by F in principal axes, F = U diag(s) V^T: with A = U^T dF V the quadratic
/// form is sum_ij scaling_ij A_ii A_jj + sum over pairs i < j, k the third, of
/// same_k (A_ij^2 + A_ji^2) + 2 cross_k A_ij A_ji.
struct PrincipalCurvature {
  Eigen::Matrix3d u, v;
  Eigen::Matrix3d scaling;
  Eigen::Vector3d same, cross;
};
/// @param project negative eigenvalues are set to zero.
PrincipalCurvature curvature(const LawConstants& law, const Eigen::Matrix3d& f, bool project);

}  // namespace glisson::fem
