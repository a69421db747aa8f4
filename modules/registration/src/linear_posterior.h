// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "force_rows.h"
#include "glisson/core/run_context.h"

namespace glisson::registration {

/// What rows of a cloud leave open of unknowns that are normal beforehand: y = A x + noise, x = N(0, prior).
struct LinearPosterior {
  Eigen::MatrixXd answers;   ///< A: rows x unknowns
  Eigen::VectorXd variance;  ///< of each row's noise
  Eigen::VectorXd y;
  Eigen::MatrixXd root;  ///< unknowns x unknowns: the covariance is root root^T
  Eigen::VectorXd mean;
  Eigen::VectorXd left;                           ///< y - A mean
  std::vector<std::vector<Eigen::Index>> places;  ///< rows that lie together, see group()

  /// @param prior variance of each unknown.
  void solve(const Eigen::VectorXd& prior);
  /// Which of the surface's rows lie in one place of about this width, m.
  void group(const ForceRows& rows, double width);

  /// (A P A^T + V)^-1 v, with prior covariance P and noise V. @pre solve().
  Eigen::VectorXd apart(const Eigen::VectorXd& v) const;
  /// How many of the first `count` unknowns the rows decide: the prior's variance, 1, less what is left.
  double decided(Eigen::Index count) const;
  /// Each place predicted from all others: mean squares over the places of the mean distance that remains, in
  /// m2, and in its variances. Cancelled: zeros.
  std::pair<double, double> held_out(const RunContext& context) const;
};

}  // namespace glisson::registration
