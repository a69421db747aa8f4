// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "glisson/fem/composite_model.h"
#include "glisson/fem/tetrahedron.h"

namespace glisson::fem {

/// Constant-strain triangle in plane stress, co-rotational by the polar decomposition F (3 x 2) = Q S in its
/// own plane: energy h A (mu |S - I|^2 + lambda'/2 tr(S - I)^2), lambda' = E nu / (1 - nu^2). Its force is
/// exactly the energy's derivative (edge frames are 6 to 10 % off).
struct Membrane {
  std::array<int, 3> nodes{};
  Eigen::Matrix<double, 2, 3> gradients;  ///< in the rest plane, 1/m
  double volume = 0.0;                    ///< thickness times rest area, m3
  double mu = 0.0, lambda = 0.0;          ///< plane stress, Pa

  /// @pre the triangle is not degenerate.
  Membrane(const std::array<int, 3>& node_indices, const Eigen::Matrix3d& rest, const Material& material,
           double thickness);
  Eigen::Matrix<double, 3, 2> deformation_gradient(const Points& x) const;
};

double energy_density(const Membrane& element, const Eigen::Matrix<double, 3, 2>& f);
Eigen::Matrix<double, 3, 2> stress(const Membrane& element, const Eigen::Matrix<double, 3, 2>& f);
/// 9 x 9, N/m, node-major.
Eigen::Matrix<double, 9, 9> tangent(const Membrane& element, const Eigen::Matrix<double, 3, 2>& f,
                                    Tangent kind);

}  // namespace glisson::fem
