// SPDX-License-Identifier: GPL-3.0-or-later
#include "tetrahedron.h"

#include <Eigen/Dense>
#include <cmath>

#include "cofactor.h"
#include "polar.h"

namespace glisson::fem {
namespace {

/// Smith et al. 2018, section 3.4: mu_s and lambda_s such that small strains see Lame's mu and lambda.
struct StableNeoHookean {
  double mu, lambda, alpha;
  explicit StableNeoHookean(const Tetrahedron& e)
      : mu(4.0 / 3.0 * e.mu), lambda(e.lambda + 5.0 / 6.0 * e.mu), alpha(1.0 + 0.75 * mu / lambda) {}
};

Eigen::Matrix3d linear_stress(const Tetrahedron& e, const Eigen::Matrix3d& stretch) {
  const Eigen::Matrix3d strain = stretch - Eigen::Matrix3d::Identity();
  return 2.0 * e.mu * strain + e.lambda * strain.trace() * Eigen::Matrix3d::Identity();
}

/// First and second derivatives of the density by the signed singular values.
void principal_derivatives(const Tetrahedron& e, TetrahedronLaw law, const Eigen::Vector3d& s,
                           Eigen::Vector3d& first, Eigen::Matrix3d& second) {
  if (law == TetrahedronLaw::corotational) {
    first = 2.0 * e.mu * (s.array() - 1.0).matrix() + Eigen::Vector3d::Constant(e.lambda * (s.sum() - 3.0));
    second = 2.0 * e.mu * Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(e.lambda);
    return;
  }
  const StableNeoHookean p(e);
  const double ic = s.squaredNorm(), j = s.prod();
  const Eigen::Vector3d g(s[1] * s[2], s[2] * s[0], s[0] * s[1]);
  first = p.mu * (1.0 - 1.0 / (ic + 1.0)) * s + p.lambda * (j - p.alpha) * g;
  second = p.mu * (1.0 - 1.0 / (ic + 1.0)) * Eigen::Matrix3d::Identity() +
           2.0 * p.mu / ((ic + 1.0) * (ic + 1.0)) * s * s.transpose() + p.lambda * g * g.transpose();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (i != k) second(i, k) += p.lambda * (j - p.alpha) * s[3 - i - k];
}

/// (first_i - first_j) / (s_i - s_j), by the law's closed form where the difference vanishes.
double flip_eigenvalue(const Tetrahedron& e, TetrahedronLaw law, const Eigen::Vector3d& s, int k) {
  if (law == TetrahedronLaw::corotational) return 2.0 * e.mu;
  const StableNeoHookean p(e);
  return p.mu * (1.0 - 1.0 / (s.squaredNorm() + 1.0)) - p.lambda * (s.prod() - p.alpha) * s[k];
}

/// (first_i + first_j) / (s_i + s_j).
double twist_eigenvalue(const Tetrahedron& e, TetrahedronLaw law, const Eigen::Vector3d& s, int k) {
  if (law == TetrahedronLaw::neo_hookean) {
    const StableNeoHookean p(e);
    return p.mu * (1.0 - 1.0 / (s.squaredNorm() + 1.0)) + p.lambda * (s.prod() - p.alpha) * s[k];
  }
  const double sum = std::max(s.sum() - s[k], 0.05);  // where the rotation jumps
  return 2.0 * e.mu + (2.0 * e.lambda * (s.sum() - 3.0) - 4.0 * e.mu) / sum;
}

/// The second derivative of the density by F, projected or not, as sum of lambda_m d_m d_m^T over its nine
/// eigen matrices d_m (isotropic laws: Smith et al. 2019, "Analytic eigensystems").
Eigen::Matrix<double, 12, 12> spectral_tangent(const Tetrahedron& e, TetrahedronLaw law,
                                               const Eigen::Matrix3d& f, bool project) {
  Eigen::Matrix3d u, v, second;
  Eigen::Vector3d s, first;
  rotation_svd(f, u, s, v);
  principal_derivatives(e, law, s, first, second);
  const Eigen::Matrix<double, 3, 4> g = v.transpose() * e.gradients;
  Eigen::Matrix<double, 12, 12> k = Eigen::Matrix<double, 12, 12>::Zero();
  const auto add = [&](const Eigen::Matrix3d& mode, double value) {
    if (project && !(value > 0.0)) return;
    const Eigen::Matrix<double, 3, 4> columns = u * mode * g;
    const Eigen::Map<const Eigen::Matrix<double, 12, 1>> d(columns.data());
    k.noalias() += (e.volume * value) * d * d.transpose();
  };
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> scaling(second);
  for (int m = 0; m < 3; ++m)
    add(Eigen::Vector3d(scaling.eigenvectors().col(m)).asDiagonal(), scaling.eigenvalues()[m]);
  for (int m = 0; m < 3; ++m) {
    const int i = (m + 1) % 3, j = (m + 2) % 3;
    Eigen::Matrix3d mode = Eigen::Matrix3d::Zero();
    mode(i, j) = mode(j, i) = std::sqrt(0.5);
    add(mode, flip_eigenvalue(e, law, s, m));
    mode(j, i) = -mode(i, j);
    add(mode, twist_eigenvalue(e, law, s, m));
  }
  return k;
}

Eigen::Matrix<double, 12, 12> rotated_tangent(const Tetrahedron& e, const Eigen::Matrix3d& rotation) {
  const Eigen::Matrix<double, 3, 4> g = rotation * e.gradients;
  Eigen::Matrix<double, 12, 12> k;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      k.block<3, 3>(3 * i, 3 * j) =
          e.volume * (e.lambda * g.col(i) * g.col(j).transpose() + e.mu * g.col(j) * g.col(i).transpose() +
                      e.mu * g.col(i).dot(g.col(j)) * Eigen::Matrix3d::Identity());
  return k;
}

}  // namespace

Tetrahedron::Tetrahedron(const std::array<int, 4>& node_indices, const Eigen::Matrix<double, 3, 4>& rest,
                         const Material& material)
    : nodes(node_indices), mu(Lame(material).mu), lambda(Lame(material).lambda) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = rest.col(k + 1) - rest.col(0);
  const double determinant = edges.determinant();
  volume = determinant / 6.0;
  gradients.rightCols<3>() = edges.inverse().transpose();
  gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
}

Eigen::Matrix3d Tetrahedron::deformation_gradient(const Points& x) const {
  Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
  for (int k = 1; k < 4; ++k)
    f += (x.row(nodes[k]) - x.row(nodes[0])).transpose() * gradients.col(k).transpose();
  return f;
}

double energy_density(const Tetrahedron& e, TetrahedronLaw law, const Eigen::Matrix3d& f) {
  if (law == TetrahedronLaw::corotational) {
    const Eigen::Matrix3d strain = polar_decomposition(f).stretch - Eigen::Matrix3d::Identity();
    const double trace = strain.trace();
    return e.mu * strain.squaredNorm() + 0.5 * e.lambda * trace * trace;
  }
  const StableNeoHookean p(e);
  const double ic = f.squaredNorm(), j = f.determinant() - p.alpha, j0 = 1.0 - p.alpha;
  // Less the value at rest, which is not zero in this law.
  return 0.5 * p.mu * (ic - 3.0 - std::log((ic + 1.0) / 4.0)) + 0.5 * p.lambda * (j * j - j0 * j0);
}

Eigen::Matrix3d stress(const Tetrahedron& e, TetrahedronLaw law, const Eigen::Matrix3d& f) {
  if (law == TetrahedronLaw::corotational) {
    const Polar polar = polar_decomposition(f);
    return polar.rotation * linear_stress(e, polar.stretch);
  }
  const StableNeoHookean p(e);
  return p.mu * (1.0 - 1.0 / (f.squaredNorm() + 1.0)) * f +
         p.lambda * (f.determinant() - p.alpha) * cofactor(f);
}

Eigen::Matrix<double, 12, 12> tangent(const Tetrahedron& e, TetrahedronLaw law, const Eigen::Matrix3d& f,
                                      Tangent kind) {
  if (law == TetrahedronLaw::corotational && kind == Tangent::rotated)
    return rotated_tangent(e, polar_decomposition(f).rotation);
  return spectral_tangent(e, law, f, kind != Tangent::exact);
}

double von_mises(const Tetrahedron& e, TetrahedronLaw law, const Eigen::Matrix3d& f) {
  Eigen::Matrix3d sigma;
  if (law == TetrahedronLaw::corotational)
    sigma = linear_stress(e, polar_decomposition(f).stretch);
  else
    sigma = stress(e, law, f) * f.transpose() / f.determinant();
  const Eigen::Matrix3d deviator = sigma - sigma.trace() / 3.0 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

}  // namespace glisson::fem
