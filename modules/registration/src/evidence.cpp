// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <vector>

#include "glisson/core/error.h"

namespace glisson::registration {
namespace {

/// I + G^1/2 (A^T Sigma^-1 A) G^1/2 of the columns whose variance is not zero, factorised.
struct Whitened {
  std::vector<int> columns;  ///< of the problem
  Eigen::VectorXd root;      ///< of their variances
  Eigen::LLT<Eigen::MatrixXd> factor;
  Eigen::VectorXd mean;  ///< of their amplitudes

  Whitened(const EvidenceProblem& problem, const Eigen::VectorXd& variances) {
    for (int k = 0; k < problem.columns(); ++k)
      if (variances[k] > 0.0) columns.push_back(k);
    const auto n = static_cast<Eigen::Index>(columns.size());
    root = variances(columns).cwiseSqrt();
    Eigen::MatrixXd b = root.asDiagonal() * problem.normal(columns, columns) * root.asDiagonal();
    b.diagonal().array() += 1.0;
    factor.compute(b);
    mean = n == 0 ? Eigen::VectorXd()
                  : Eigen::VectorXd(root.cwiseProduct(
                        factor.solve(root.cwiseProduct(Eigen::VectorXd(problem.projected(columns))))));
  }
};

}  // namespace

EvidenceProblem::EvidenceProblem(const Eigen::MatrixXd& a, const Eigen::VectorXd& y,
                                 const Eigen::VectorXd& sigma, int group_count, int columns_a_group,
                                 Eigen::VectorXd fixed)
    : groups(group_count), group_size(columns_a_group), fixed_variance(std::move(fixed)) {
  require(a.cols() == groups * group_size + fixed_variance.size(), "every column has a variance");
  require(a.rows() == y.size() && y.size() == sigma.size(), "every observation has a row and a deviation");
  const Eigen::VectorXd inverse = sigma.cwiseInverse();
  const Eigen::MatrixXd white = inverse.asDiagonal() * a;
  const Eigen::VectorXd target = inverse.cwiseProduct(y);
  normal.setZero(a.cols(), a.cols());
  normal.selfadjointView<Eigen::Lower>().rankUpdate(white.transpose());
  normal.triangularView<Eigen::StrictlyUpper>() = normal.transpose();
  projected = white.transpose() * target;
  square = target.squaredNorm();
  log_noise =
      -sigma.array().log().sum() - 0.5 * static_cast<double>(y.size()) * std::log(2.0 * std::numbers::pi);
}

EvidenceProblem EvidenceProblem::of_groups() const {
  // With N the normal matrix, g the groups' columns, f the fixed ones and C their variances:
  // N' = N_gg - N_gf C^1/2 (I + C^1/2 N_ff C^1/2)^-1 C^1/2 N_fg, and the same of what is projected.
  const Eigen::Index own = static_cast<Eigen::Index>(groups) * group_size, fixed = fixed_variance.size();
  const Eigen::VectorXd root = fixed_variance.cwiseSqrt();
  Eigen::MatrixXd inner = root.asDiagonal() * normal.bottomRightCorner(fixed, fixed) * root.asDiagonal();
  inner.diagonal().array() += 1.0;
  const Eigen::LLT<Eigen::MatrixXd> factor(inner);
  const Eigen::MatrixXd across =
      factor.matrixL().solve(root.asDiagonal() * normal.bottomLeftCorner(fixed, own));
  const Eigen::VectorXd seen = factor.matrixL().solve(root.cwiseProduct(projected.tail(fixed)));
  EvidenceProblem problem;
  problem.groups = groups;
  problem.group_size = group_size;
  problem.normal = normal.topLeftCorner(own, own);
  problem.normal.noalias() -= across.transpose() * across;
  problem.projected = projected.head(own) - across.transpose() * seen;
  problem.square = square - seen.squaredNorm();
  problem.log_noise = log_noise - factor.matrixLLT().diagonal().array().log().sum();
  return problem;
}

Eigen::VectorXd EvidenceProblem::column_variances(const Eigen::VectorXd& group_variance) const {
  Eigen::VectorXd variances(columns());
  for (int j = 0; j < groups; ++j)
    variances.segment(j * group_size, group_size).setConstant(group_variance[j]);
  variances.tail(fixed_variance.size()) = fixed_variance;
  return variances;
}

EvidencePosterior posterior(const EvidenceProblem& problem, const Eigen::VectorXd& group_variance) {
  const Whitened white(problem, problem.column_variances(group_variance));
  EvidencePosterior result;
  const auto n = static_cast<Eigen::Index>(white.columns.size());
  result.mean.setZero(problem.columns());
  result.mean(white.columns) = white.mean;
  // (L L^T)^-1 = L^-T L^-1.
  Eigen::MatrixXd upper = Eigen::MatrixXd::Identity(n, n);
  white.factor.matrixU().solveInPlace(upper);
  result.root.setZero(problem.columns(), n);
  result.root(white.columns, Eigen::all) = white.root.asDiagonal() * upper;
  const Eigen::MatrixXd& l = white.factor.matrixLLT();
  result.log_evidence = problem.log_noise - l.diagonal().array().log().sum() -
                        0.5 * (problem.square - problem.projected.dot(result.mean));
  return result;
}

Eigen::VectorXd maximise_evidence(const EvidenceProblem& problem, Eigen::VectorXd gamma, int updates,
                                  double gone, const RunContext& context) {
  const int size = problem.group_size;
  for (int update = 0; update < updates && !context.cancelled(); ++update) {
    const Whitened white(problem, problem.column_variances(gamma));
    const auto n = static_cast<Eigen::Index>(white.columns.size());
    Eigen::MatrixXd lower = Eigen::MatrixXd::Identity(n, n);
    white.factor.matrixL().solveInPlace(lower);
    // g tr(A_j^T M^-1 A_j) is 1 less the posterior variance over the prior's, summed over the group.
    const Eigen::VectorXd left = lower.colwise().squaredNorm();
    Eigen::Index at = 0;
    for (int j = 0; j < problem.groups; ++j) {
      if (!(gamma[j] > 0.0)) continue;
      const double trace = (size - left.segment(at, size).sum()) / gamma[j];
      const double length = white.mean.segment(at, size).norm();
      at += size;
      gamma[j] = length / std::sqrt(std::max(trace, 1e-300));
    }
    const double least = gone * gamma.maxCoeff();
    for (double& g : gamma)
      if (!(g > least)) g = 0.0;
  }
  return gamma;
}

Eigen::VectorXd evidence_of_groups(const EvidenceProblem& problem, const Eigen::VectorXd& gamma) {
  const EvidencePosterior all = posterior(problem, gamma);
  const int size = problem.group_size;
  Eigen::VectorXd added = Eigen::VectorXd::Zero(problem.groups);
  for (int j = 0; j < problem.groups; ++j) {
    if (!(gamma[j] > 0.0)) continue;
    const Eigen::MatrixXd root = all.root.middleRows(j * size, size);
    const Eigen::LLT<Eigen::MatrixXd> factor(Eigen::MatrixXd(root * root.transpose()));
    const Eigen::VectorXd mean = all.mean.segment(j * size, size);
    added[j] = 0.5 * mean.dot(factor.solve(mean)) + factor.matrixLLT().diagonal().array().log().sum() -
               0.5 * size * std::log(gamma[j]);
  }
  return added;
}

Eigen::VectorXd keep_worth(const EvidenceProblem& problem, Eigen::VectorXd gamma, double price,
                           const RunContext& context) {
  while (!context.cancelled()) {
    const Eigen::VectorXd added = evidence_of_groups(problem, gamma);
    int least = -1;
    for (int j = 0; j < problem.groups; ++j)
      if (gamma[j] > 0.0 && added[j] < price && (least < 0 || added[j] < added[least])) least = j;
    if (least < 0) return gamma;
    gamma[least] = 0.0;
    gamma = maximise_evidence(problem, std::move(gamma), 1);
  }
  return gamma;
}

}  // namespace glisson::registration
