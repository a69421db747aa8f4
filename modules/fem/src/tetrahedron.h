// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "glisson/fem/composite_model.h"

namespace glisson::fem {

/// Shear modulus and Lame's first parameter, Pa.
struct Lame {
  double mu = 0.0, lambda = 0.0;
  explicit Lame(const Material& material)
      : mu(material.young_modulus / (2.0 * (1.0 + material.poisson_ratio))),
        lambda(material.young_modulus * material.poisson_ratio /
               ((1.0 + material.poisson_ratio) * (1.0 - 2.0 * material.poisson_ratio))) {}
};

/// What stands in the system matrix for an element's second derivative. All are symmetric, the first two also
/// positive semi-definite (beams: the strains' squares without their second derivatives).
enum class Tangent {
  rotated,    ///< R^T K0 R: linear elasticity in the current frame (paper, eq. 3). Neo-Hookean: as projected
  projected,  ///< the exact second derivative with its negative eigenvalues set to zero
  exact       ///< the second derivative itself
};

/// One linear tetrahedron with an isotropic law. Co-rotational: psi = mu |S - I|^2 + lambda/2 tr(S - I)^2
/// with F = Q S; its force is exactly the paper's R^T K0 (R x - x0), R = Q^T. Neo-Hookean: Smith, de Goes and
/// Kim 2018 (stable under inversion), with its parameters mapped so that small strains agree with Lame's.
struct Tetrahedron {
  std::array<int, 4> nodes{};
  Eigen::Matrix<double, 3, 4> gradients;  ///< of the shape functions, 1/m
  double volume = 0.0;                    ///< m3
  double mu = 0.0, lambda = 0.0;          ///< Lame's, Pa

  /// @pre the four points are positively oriented.
  Tetrahedron(const std::array<int, 4>& node_indices, const Eigen::Matrix<double, 3, 4>& rest,
              const Material& material);
  /// F from the rest shape to node positions x (one row a node of the whole mesh, metres); identity at rest.
  Eigen::Matrix3d deformation_gradient(const Points& x) const;
};

/// Energy density, J/m3.
double energy_density(const Tetrahedron& element, TetrahedronLaw law, const Eigen::Matrix3d& f);
/// First Piola-Kirchhoff stress, Pa: the density's derivative by F.
Eigen::Matrix3d stress(const Tetrahedron& element, TetrahedronLaw law, const Eigen::Matrix3d& f);
/// The 12 x 12 tangent (N/m), node-major.
Eigen::Matrix<double, 12, 12> tangent(const Tetrahedron& element, TetrahedronLaw law,
                                      const Eigen::Matrix3d& f, Tangent kind);
/// Von Mises stress of the Cauchy stress, Pa (co-rotational: of the linear stress).
double von_mises(const Tetrahedron& element, TetrahedronLaw law, const Eigen::Matrix3d& f);

}  // namespace glisson::fem
