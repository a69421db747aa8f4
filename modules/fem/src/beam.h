// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/fem/composite_model.h"

namespace glisson::fem {

/// Stiffnesses of a hollow circular section.
struct BeamSection {
  double axial = 0.0;    ///< E A, N
  double bending = 0.0;  ///< E I, N m2
  double torsion = 0.0;  ///< G J, N m2
  double shear = 0.0;    ///< kappa G A, N; kappa of a hollow circle after Cowper 1966

  /// @param outer_radius m; @param wall m, at most the radius (then the section is solid).
  static BeamSection hollow(double outer_radius, double wall, const Material& material);
};

/// A node of a beam: where it is and how its frame has turned since rest.
struct BeamNodeState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

/// Straight Timoshenko beam between two 6-DoF nodes, co-rotational in the mean of its nodes' frames.
///
/// Strains: gamma = Rm^T (p2 - p1) / L - e (stretch and shear), kappa = log(R1^T R2) / L (twist and bending).
/// Energy L/2 (gamma C_gamma gamma + kappa C_kappa kappa) with the shear stiffness
/// 1 / (1 / (kappa G A) + L^2 / (12 E I)) = 12 E I / (L^2 (1 + Phi)): for small displacements this is the
/// 12 x 12 Timoshenko matrix with Phi = 12 E I / (kappa G A L^2), entry by entry (MacNeal 1978). gradient()
/// is exactly the energy's derivative, at any rotation (nodes less than 180 degrees apart).
class BeamElement {
 public:
  using Gradient = Eigen::Matrix<double, 12, 1>;  ///< force, moment on node 1; force, moment on node 2
  /// Rows: the six strains, scaled so that rows^T rows is the stiffness. Columns as in Gradient.
  using Rows = Eigen::Matrix<double, 6, 12>;

  /// @pre the nodes are apart.
  BeamElement(const Eigen::Vector3d& rest_1, const Eigen::Vector3d& rest_2, const BeamSection& section);

  double length() const { return length_; }
  /// Elastic energy, J; zero at rest and under any rigid motion. Positions are metres, in the rest's frame.
  double energy(const BeamNodeState& a, const BeamNodeState& b) const;
  /// Derivative by displacement and by spatial rotation vector of each node, N and N m.
  Gradient gradient(const BeamNodeState& a, const BeamNodeState& b) const;
  /// Square root of the tangent without the strains' second derivatives (exact at rest): K_v = rows^T rows.
  Rows stiffness_rows(const BeamNodeState& a, const BeamNodeState& b) const;
  /// The gradient's whole derivative, columns as in Gradient. Not symmetric away from equilibrium (spatial
  /// rotation vectors do not commute); bound to a body's displacements (vessel_beams.h) it becomes so.
  Eigen::Matrix<double, 12, 12> gradient_rate(const BeamNodeState& a, const BeamNodeState& b) const;
  /// Both at once.
  void linearise(const BeamNodeState& a, const BeamNodeState& b, Gradient& gradient, Rows& rows) const;

 private:
  struct Kinematics;
  Gradient gradient_of(const Kinematics& k) const;
  Rows rows_of(const Kinematics& k) const;
  Kinematics kinematics(const BeamNodeState& a, const BeamNodeState& b) const;

  Eigen::Vector3d axis_;
  double length_;
  Eigen::Matrix3d c_gamma_, c_kappa_;
  Eigen::Matrix3d sqrt_gamma_, sqrt_kappa_;  ///< times the square root of L, or over it
};

}  // namespace glisson::fem
