// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "glisson/fem/composite_model.h"
#include "tetrahedron.h"

namespace glisson::fem {

/// Constant-strain triangle in plane stress: a sheet of thickness h and rest area A. F (3 x 2) takes the rest
/// plane to space; its polar decomposition F = Q S gives the co-rotational energy
/// h A (mu |S - I|^2 + lambda'/2 tr(S - I)^2) with lambda' = E nu / (1 - nu^2). The force is exactly the
/// energy's derivative, which it would not be with a frame along an edge. Compression is borne like tension:
/// no wrinkles. A value; safe to read from any thread.
struct Membrane {
  std::array<int, 3> nodes{};
  Eigen::Matrix<double, 2, 3> gradients;  ///< of the shape functions, in the rest plane, 1/m
  double volume = 0.0;                    ///< thickness times rest area, m3
  double mu = 0.0, lambda = 0.0;          ///< plane stress, Pa

  /// @param rest corners as columns, metres. @param thickness metres. @pre the triangle is not degenerate.
  Membrane(const std::array<int, 3>& node_indices, const Eigen::Matrix3d& rest, const Material& material,
           double thickness);
  /// F at node positions x (one row a node of the whole mesh, metres).
  Eigen::Matrix<double, 3, 2> deformation_gradient(const Points& x) const;
};

/// Energy density, J/m3 of the sheet at rest.
double energy_density(const Membrane& element, const Eigen::Matrix<double, 3, 2>& f);
/// First Piola-Kirchhoff stress, Pa: the density's derivative by F.
Eigen::Matrix<double, 3, 2> stress(const Membrane& element, const Eigen::Matrix<double, 3, 2>& f);
/// The 9 x 9 tangent stiffness, N/m, node-major.
Eigen::Matrix<double, 9, 9> tangent(const Membrane& element, const Eigen::Matrix<double, 3, 2>& f,
                                    Tangent kind);

}  // namespace glisson::fem
