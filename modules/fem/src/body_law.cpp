// SPDX-License-Identifier: GPL-3.0-or-later
#include "body_law.h"

#include <Eigen/Dense>
#include <cmath>

#include "cofactor.h"
#include "glisson/core/error.h"
#include "polar.h"

namespace glisson::fem {
namespace {

constexpr double kSmallestSum = 0.05;  ///< of two stretches, where the rotation jumps

/// ln J and its derivatives; below kTaylor the Taylor polynomial of second order.
struct Logarithm {
  double value, first, second;
  explicit Logarithm(double j) {
    constexpr double kTaylor = 0.2;
    if (j > kTaylor) {
      value = std::log(j), first = 1.0 / j, second = -1.0 / (j * j);
      return;
    }
    const double d = (j - kTaylor) / kTaylor;
    value = std::log(kTaylor) + d - 0.5 * d * d;
    first = (1.0 - d) / kTaylor;
    second = -1.0 / (kTaylor * kTaylor);
  }
};

bool positive_definite(const Eigen::Matrix3d& m) {
  return m(0, 0) > 0.0 && m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0) > 0.0 && m.determinant() > 0.0;
}

Eigen::Matrix3d without_negative(const Eigen::Matrix3d& m) {
  if (positive_definite(m)) return m;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(m);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// Eigenvalues of the antisymmetric and symmetric parts of A across a plane.
void set_plane(PrincipalCurvature& c, int k, double twist, double flip, bool project) {
  if (project) twist = std::max(twist, 0.0), flip = std::max(flip, 0.0);
  c.same[k] = 0.5 * (flip + twist);
  c.cross[k] = 0.5 * (flip - twist);
}

}  // namespace

const char* body_law_code(BodyLaw law) {
  switch (law) {
    case BodyLaw::linear:
      return "linear";
    case BodyLaw::corotational:
      return "corotational";
    case BodyLaw::neo_hookean:
      break;
  }
  return "neo_hookean";
}

LawConstants::LawConstants(const BodyMaterial& material)
    : law(material.law),
      mu(0.5 / (1.0 + material.poisson_ratio)),
      lambda(material.poisson_ratio /
             ((1.0 + material.poisson_ratio) * (1.0 - 2.0 * material.poisson_ratio))) {
  const OptionCheck demand("elastic law");
  demand(material.poisson_ratio > -1.0 && material.poisson_ratio < 0.5, "poisson_ratio",
         material.poisson_ratio, "Give a number between -1 and 0.5");
}

double density(const LawConstants& law, const Eigen::Matrix3d& f, Eigen::Matrix3d& stress) {
  switch (law.law) {
    case BodyLaw::linear: {
      const Eigen::Matrix3d strain = 0.5 * (f + f.transpose()) - Eigen::Matrix3d::Identity();
      const double trace = strain.trace();
      stress = 2.0 * law.mu * strain + law.lambda * trace * Eigen::Matrix3d::Identity();
      return law.mu * strain.squaredNorm() + 0.5 * law.lambda * trace * trace;
    }
    case BodyLaw::corotational: {
      const Polar polar = polar_decomposition(f);
      const Eigen::Matrix3d strain = polar.stretch - Eigen::Matrix3d::Identity();
      const double trace = strain.trace();
      stress = polar.rotation * (2.0 * law.mu * strain + law.lambda * trace * Eigen::Matrix3d::Identity());
      return law.mu * strain.squaredNorm() + 0.5 * law.lambda * trace * trace;
    }
    case BodyLaw::neo_hookean:
      break;
  }
  const Eigen::Matrix3d c = cofactor(f);
  const Logarithm log(f.col(0).dot(c.col(0)));
  stress = law.mu * f + (law.lambda * log.value - law.mu) * log.first * c;
  return 0.5 * law.mu * (f.squaredNorm() - 3.0) + (0.5 * law.lambda * log.value - law.mu) * log.value;
}

double density(const LawConstants& law, const Eigen::Matrix3d& f) {
  if (law.law == BodyLaw::neo_hookean) {
    const Logarithm log(f.determinant());
    return 0.5 * law.mu * (f.squaredNorm() - 3.0) + (0.5 * law.lambda * log.value - law.mu) * log.value;
  }
  Eigen::Matrix3d stress;
  return density(law, f, stress);
}

PrincipalCurvature curvature(const LawConstants& law, const Eigen::Matrix3d& f, bool project) {
  PrincipalCurvature c;
  const Eigen::Matrix3d small =
      2.0 * law.mu * Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(law.lambda);
  if (law.law == BodyLaw::linear) {
    c.u = c.v = Eigen::Matrix3d::Identity();
    c.scaling = small;
    for (int k = 0; k < 3; ++k) set_plane(c, k, 0.0, 2.0 * law.mu, project);
    return c;
  }
  Eigen::Vector3d s;
  rotation_svd(f, c.u, s, c.v);
  if (law.law == BodyLaw::corotational) {
    c.scaling = small;
    for (int k = 0; k < 3; ++k) {
      const double sum = std::max(s.sum() - s[k], kSmallestSum);
      set_plane(c, k, 2.0 * law.mu + (2.0 * law.lambda * (s.sum() - 3.0) - 4.0 * law.mu) / sum, 2.0 * law.mu,
                project);
    }
    return c;
  }
  const Logarithm log(s.prod());
  const double slope = (law.lambda * log.value - law.mu) * log.first;
  const double bend = (law.lambda * log.value - law.mu) * log.second + law.lambda * log.first * log.first;
  const Eigen::Vector3d g(s[1] * s[2], s[2] * s[0], s[0] * s[1]);
  c.scaling = law.mu * Eigen::Matrix3d::Identity() + bend * g * g.transpose();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j) c.scaling(i, j) += slope * s[3 - i - j];
  if (project) c.scaling = without_negative(c.scaling);
  for (int k = 0; k < 3; ++k) set_plane(c, k, law.mu + slope * s[k], law.mu - slope * s[k], project);
  return c;
}

}  // namespace glisson::fem
