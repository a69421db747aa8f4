// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace glisson::fem {

/// F = Q S with Q a rotation (det = +1) and S symmetric. An inverted F (det < 0) gives S one negative
/// eigenvalue, the one smallest in magnitude: the nearest rotation, as for an upright element.
struct Polar {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();
  double determinant = 1.0;  ///< of F
};

/// Newton's iteration, scaled (Higham 1986), where F is well conditioned; singular values otherwise. A
/// function of F alone: no warm start, so that a result never depends on what was computed before.
Polar polar_decomposition(const Eigen::Matrix3d& f);

/// The rotation's derivative: for F = Q S, a change dF turns Q by the spatial vector
/// Q (tr(S) I - S)^-1 Q^T axial, axial = sum((Q grad N_i) x dx_i). Returns Q (tr(S) I - S)^-1 Q^T.
/// Sums of two stretches below `floor` (an element that is nearly flat or inverted, where the rotation jumps)
/// are raised to it, so that the result stays finite.
Eigen::Matrix3d rotation_rate(const Polar& polar, double floor = 0.05);

/// Signed singular values: f = u diag(sigma) v^T, u and v rotations; only sigma[2] may be negative.
void rotation_svd(const Eigen::Matrix3d& f, Eigen::Matrix3d& u, Eigen::Vector3d& sigma, Eigen::Matrix3d& v);

/// F (3 x 2) = Q S with Q's columns orthonormal and S (2 x 2) symmetric positive semi-definite.
struct PlanePolar {
  Eigen::Matrix<double, 3, 2> rotation;
  Eigen::Matrix2d stretch;
};
/// S is the root of F^T F, in closed form. An F of rank one or zero is completed by directions of our choice,
/// so that Q's columns are orthonormal for any finite F. A function of F alone.
PlanePolar plane_polar_decomposition(const Eigen::Matrix<double, 3, 2>& f);

}  // namespace glisson::fem
