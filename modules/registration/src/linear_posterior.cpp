// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear_posterior.h"

#include <Eigen/Dense>

#include "farthest_first.h"

namespace glisson::registration {

void LinearPosterior::solve(const Eigen::VectorXd& prior) {
  const Eigen::MatrixXd weighted = variance.cwiseInverse().asDiagonal() * answers;
  Eigen::MatrixXd h = answers.transpose() * weighted;
  h.diagonal() += prior.cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> factor(h);
  root = factor.matrixU().solve(Eigen::MatrixXd::Identity(h.rows(), h.cols()));
  mean = factor.solve(weighted.transpose() * y);
  left = y - answers * mean;
}

void LinearPosterior::group(const ForceRows& rows, double width) {
  const Spread spread = farthest_first(rows.points.topRows(rows.surface_count), width);
  places.assign(spread.chosen.size(), {});
  for (std::size_t i = 0; i < spread.nearest.size(); ++i)
    places[spread.nearest[i]].push_back(static_cast<Eigen::Index>(i));
}

Eigen::VectorXd LinearPosterior::apart(const Eigen::VectorXd& v) const {
  const Eigen::VectorXd weighed = v.cwiseQuotient(variance);
  const Eigen::VectorXd along = root * (root.transpose() * (answers.transpose() * weighed));
  return weighed - (answers * along).cwiseQuotient(variance);
}

double LinearPosterior::decided(Eigen::Index count) const {
  return static_cast<double>(count) - root.topRows(count).squaredNorm();
}

std::pair<double, double> LinearPosterior::held_out(const RunContext& context) const {
  std::pair<double, double> sums{0.0, 0.0};
  if (places.size() < 2) return sums;
  for (const auto& place : places) {
    if (context.cancelled()) return {0.0, 0.0};
    // Left out, the place's residual is V (V - H)^-1 e, of covariance V (V - H)^-1 V; H = A S A^T.
    const Eigen::MatrixXd a = answers(place, Eigen::all) * root;
    Eigen::MatrixXd m = -a * a.transpose();
    const Eigen::VectorXd v = variance(place);
    m.diagonal() += v;
    const Eigen::LDLT<Eigen::MatrixXd> factor(m);
    const auto count = static_cast<double>(place.size());
    const double distance = v.dot(factor.solve(Eigen::VectorXd(left(place)))) / count;
    sums.first += distance * distance;
    sums.second += distance * distance / (v.dot(factor.solve(v)) / (count * count));
  }
  const auto count = static_cast<double>(places.size());
  return {sums.first / count, sums.second / count};
}

}  // namespace glisson::registration
