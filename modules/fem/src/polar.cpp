// SPDX-License-Identifier: GPL-3.0-or-later
#include "polar.h"

#include <Eigen/Dense>
#include <cmath>

#include "cofactor.h"

namespace glisson::fem {
namespace {

/// @return false when it did not settle.
bool newton_polar(const Eigen::Matrix3d& f, Eigen::Matrix3d& q) {
  q = f;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Matrix3d c = cofactor(q);
    const double determinant = q.col(0).dot(c.col(0));
    const Eigen::Matrix3d inverse_transposed = c / determinant;
    const double scale = std::sqrt(std::sqrt(inverse_transposed.squaredNorm() / q.squaredNorm()));
    const Eigen::Matrix3d next = 0.5 * (scale * q + inverse_transposed / scale);
    const double change = (next - q).squaredNorm();
    q = next;
    // Quadratic convergence: what is left is the square of this change.
    if (change < 1e-18) return true;
  }
  return false;
}

}  // namespace

void rotation_svd(const Eigen::Matrix3d& f, Eigen::Matrix3d& u, Eigen::Vector3d& sigma, Eigen::Matrix3d& v) {
  // One-sided Jacobi: turn pairs of columns until all are orthogonal.
  Eigen::Matrix3d b = f;
  v.setIdentity();
  for (int sweep = 0; sweep < 12; ++sweep) {
    bool settled = true;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        const double pp = b.col(p).squaredNorm(), qq = b.col(q).squaredNorm(), pq = b.col(p).dot(b.col(q));
        if (!(std::abs(pq) > 1e-16 * std::sqrt(pp * qq))) continue;
        settled = false;
        const double zeta = (qq - pp) / (2.0 * pq);
        const double t = (zeta >= 0.0 ? 1.0 : -1.0) / (std::abs(zeta) + std::sqrt(1.0 + zeta * zeta));
        const double c = 1.0 / std::sqrt(1.0 + t * t), s = c * t;
        for (Eigen::Matrix3d* m : {&b, &v}) {
          const Eigen::Vector3d old = m->col(p);
          m->col(p) = c * old - s * m->col(q);
          m->col(q) = s * old + c * m->col(q);
        }
      }
    if (settled) break;
  }
  const auto order = [&](int p, int q) {  // a swap and a sign: still a rotation
    if (b.col(p).squaredNorm() >= b.col(q).squaredNorm()) return;
    for (Eigen::Matrix3d* m : {&b, &v}) {
      const Eigen::Vector3d old = m->col(p);
      m->col(p) = m->col(q);
      m->col(q) = -old;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  sigma[0] = b.col(0).norm();
  u.col(0) = sigma[0] > 0.0 ? Eigen::Vector3d(b.col(0) / sigma[0]) : Eigen::Vector3d::UnitX();
  Eigen::Vector3d second = b.col(1) - u.col(0).dot(b.col(1)) * u.col(0);
  sigma[1] = second.norm();
  if (sigma[1] <= 1e-150 + 1e-15 * sigma[0]) {  // a line or a point: any direction across will do
    int least = 0;
    u.col(0).cwiseAbs().minCoeff(&least);
    second = u.col(0).cross(Eigen::Vector3d::Unit(least));
    u.col(1) = second.normalized();
  } else {
    u.col(1) = second / sigma[1];
  }
  u.col(2) = u.col(0).cross(u.col(1));
  sigma[2] = u.col(2).dot(b.col(2));
}

Polar polar_decomposition(const Eigen::Matrix3d& f) {
  Polar polar;
  polar.determinant = f.determinant();
  const double size = f.norm();
  if (!(polar.determinant > 1e-3 * size * size * size) || !newton_polar(f, polar.rotation)) {
    if (!std::isfinite(size)) {  // the caller sees it in the stretch and refuses the state
      polar.stretch.setConstant(size);
      return polar;
    }
    Eigen::Matrix3d u, v;
    Eigen::Vector3d sigma;
    rotation_svd(f, u, sigma, v);
    polar.rotation = u * v.transpose();
    polar.stretch = v * sigma.asDiagonal() * v.transpose();
    return polar;
  }
  const Eigen::Matrix3d s = polar.rotation.transpose() * f;
  polar.stretch = 0.5 * (s + s.transpose());
  return polar;
}

Eigen::Matrix3d rotation_rate(const Polar& polar, double floor) {
  const Eigen::Matrix3d sums =
      polar.stretch.trace() * Eigen::Matrix3d::Identity() - polar.stretch;  // s2 + s3, s3 + s1, s1 + s2
  const Eigen::Matrix3d& q = polar.rotation;
  // The smallest eigenvalue is at least det / (half the trace)^2 when all are positive.
  const double trace = sums.trace();
  const double determinant = sums.determinant();
  if (polar.determinant > 0.0 && trace > 0.0 && determinant > floor * 0.25 * trace * trace)
    return q * sums.inverse() * q.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sums);
  const Eigen::Vector3d inverse = eigen.eigenvalues().cwiseMax(floor).cwiseInverse();
  return q * eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose() * q.transpose();
}

PlanePolar plane_polar_decomposition(const Eigen::Matrix<double, 3, 2>& f) {
  PlanePolar polar;
  const Eigen::Matrix2d c = f.transpose() * f;
  const double trace = c.trace();
  const double determinant = f.col(0).cross(f.col(1)).norm();  // of S: sqrt(det C), without cancellation
  if (determinant > 1e-6 * trace) {
    // Square root of a 2 x 2 matrix by Cayley and Hamilton.
    const double t = std::sqrt(trace + 2.0 * determinant);
    polar.stretch = (c + determinant * Eigen::Matrix2d::Identity()) / t;
    Eigen::Matrix2d inverse;
    inverse << polar.stretch(1, 1), -polar.stretch(0, 1), -polar.stretch(1, 0), polar.stretch(0, 0);
    polar.rotation = f * (inverse / determinant);
    return polar;
  }
  // Nearly a line or a point: the larger direction, and any across it.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(c);
  const Eigen::Vector2d v = eigen.eigenvectors().col(1), w(-v.y(), v.x());
  Eigen::Vector3d along = f * v, across = f * w;
  const double length = along.norm();
  along = length > 0.0 ? Eigen::Vector3d(along / length) : Eigen::Vector3d::UnitX();
  across -= along.dot(across) * along;
  const double width = across.norm();
  if (width <= 1e-150 + 1e-15 * length) {
    int least = 0;
    along.cwiseAbs().minCoeff(&least);
    across = along.cross(Eigen::Vector3d::Unit(least)).normalized();
  } else {
    across /= width;
  }
  polar.rotation = along * v.transpose() + across * w.transpose();
  polar.stretch = length * v * v.transpose() + width * w * w.transpose();
  return polar;
}

}  // namespace glisson::fem
