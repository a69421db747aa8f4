// SPDX-License-Identifier: GPL-3.0-or-later
#include "membrane.h"

#include <Eigen/Dense>

#include "polar.h"

namespace glisson::fem {
namespace {

Eigen::Matrix2d plane_stress(const Membrane& e, const Eigen::Matrix2d& stretch) {
  const Eigen::Matrix2d strain = stretch - Eigen::Matrix2d::Identity();
  return 2.0 * e.mu * strain + e.lambda * strain.trace() * Eigen::Matrix2d::Identity();
}

/// What R^T K0 R leaves out of the second derivative: the turn in the plane and, under tension, the bulge out
/// of it; only where it is positive when projecting.
void add_geometric(const Membrane& e, const PlanePolar& polar, bool project, Eigen::Matrix<double, 9, 9>& k) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(polar.stretch);
  const Eigen::Vector2d& s = eigen.eigenvalues();
  const Eigen::Matrix<double, 3, 2> u = polar.rotation * eigen.eigenvectors();
  const Eigen::Matrix<double, 2, 3> g = eigen.eigenvectors().transpose() * e.gradients;
  const double trace = s.sum() - 2.0;
  const auto add = [&](const Eigen::Matrix3d& columns, double value) {
    if (project && !(value > 0.0)) return;
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> d(columns.data());
    k.noalias() += (e.volume * value) * d * d.transpose();
  };
  const Eigen::Matrix3d turn = std::sqrt(0.5) * (u.col(0) * g.row(1) - u.col(1) * g.row(0));
  const double first_sum = 2.0 * e.mu * trace + 2.0 * e.lambda * trace;
  add(turn, first_sum / std::max(s.sum(), 0.05));
  const Eigen::Vector3d normal = u.col(0).cross(u.col(1));
  for (int i = 0; i < 2; ++i) {
    const double tension = 2.0 * e.mu * (s[i] - 1.0) + e.lambda * trace;
    add(normal * g.row(i), tension / std::max(s[i], 0.05));
  }
}

}  // namespace

Membrane::Membrane(const std::array<int, 3>& node_indices, const Eigen::Matrix3d& rest,
                   const Material& material, double thickness)
    : nodes(node_indices),
      mu(material.young_modulus / (2.0 * (1.0 + material.poisson_ratio))),
      lambda(material.young_modulus * material.poisson_ratio /
             (1.0 - material.poisson_ratio * material.poisson_ratio)) {
  const Eigen::Vector3d a = rest.col(1) - rest.col(0), b = rest.col(2) - rest.col(0);
  const Eigen::Vector3d ex = a.normalized();
  const Eigen::Vector3d normal = a.cross(b);
  const Eigen::Vector3d ey = normal.normalized().cross(ex);
  Eigen::Matrix2d edges;
  edges << a.dot(ex), b.dot(ex), a.dot(ey), b.dot(ey);
  volume = 0.5 * normal.norm() * thickness;
  gradients.rightCols<2>() = edges.inverse().transpose();
  gradients.col(0) = -gradients.col(1) - gradients.col(2);
}

Eigen::Matrix<double, 3, 2> Membrane::deformation_gradient(const Points& x) const {
  return (x.row(nodes[1]) - x.row(nodes[0])).transpose() * gradients.col(1).transpose() +
         (x.row(nodes[2]) - x.row(nodes[0])).transpose() * gradients.col(2).transpose();
}

double energy_density(const Membrane& e, const Eigen::Matrix<double, 3, 2>& f) {
  const Eigen::Matrix2d strain = plane_polar_decomposition(f).stretch - Eigen::Matrix2d::Identity();
  const double trace = strain.trace();
  return e.mu * strain.squaredNorm() + 0.5 * e.lambda * trace * trace;
}

Eigen::Matrix<double, 3, 2> stress(const Membrane& e, const Eigen::Matrix<double, 3, 2>& f) {
  const PlanePolar polar = plane_polar_decomposition(f);
  return polar.rotation * plane_stress(e, polar.stretch);
}

Eigen::Matrix<double, 9, 9> tangent(const Membrane& e, const Eigen::Matrix<double, 3, 2>& f, Tangent kind) {
  const PlanePolar polar = plane_polar_decomposition(f);
  const Eigen::Matrix3d g = polar.rotation * e.gradients;
  const Eigen::Matrix3d plane = polar.rotation * polar.rotation.transpose();
  Eigen::Matrix<double, 9, 9> k;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      k.block<3, 3>(3 * i, 3 * j) =
          e.volume * (e.lambda * g.col(i) * g.col(j).transpose() + e.mu * g.col(j) * g.col(i).transpose() +
                      e.mu * g.col(i).dot(g.col(j)) * plane);
  if (kind != Tangent::rotated) add_geometric(e, polar, kind == Tangent::projected, k);
  return k;
}

}  // namespace glisson::fem
