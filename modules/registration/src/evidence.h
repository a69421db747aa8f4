// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/core/run_context.h"

/// @file
/// Sparse Bayesian learning (Tipping 2001, in groups): y = A a + e, e ~ N(0, Sigma), amplitudes a of unknown
/// variance, one variance a group of columns. The variances are those under which y is most probable; most
/// become zero. That is how few of many possible forces are taken to act.

namespace glisson::registration {

/// What the evidence needs of A, Sigma and y, whatever the number of observations. Columns: first the
/// groups', then those of fixed variance. Evidences here are natural logarithms, in nats.
struct EvidenceProblem {
  Eigen::MatrixXd normal;     ///< A^T Sigma^-1 A, n x n
  Eigen::VectorXd projected;  ///< A^T Sigma^-1 y, n
  double square = 0.0;        ///< y^T Sigma^-1 y
  double log_noise = 0.0;     ///< -(ln det Sigma + m ln 2 pi) / 2
  int groups = 0, group_size = 3;
  Eigen::VectorXd fixed_variance;  ///< of the columns behind the groups', positive

  /// @param a m x n, y m, sigma m standard deviations (independent).
  EvidenceProblem(const Eigen::MatrixXd& a, const Eigen::VectorXd& y, const Eigen::VectorXd& sigma,
                  int groups, int group_size, Eigen::VectorXd fixed_variance);
  int columns() const { return static_cast<int>(projected.size()); }
  /// The same without the columns of fixed variance, which then belong to the noise: every group's evidence
  /// and posterior are the same, at a cost that falls with the cube of the columns that are left.
  EvidenceProblem of_groups() const;
  /// One variance a column.
  Eigen::VectorXd column_variances(const Eigen::VectorXd& group_variance) const;

 private:
  EvidenceProblem() = default;
};

/// The posterior of the amplitudes under given variances.
struct EvidencePosterior {
  Eigen::VectorXd mean;  ///< of the amplitudes, n; 0 where the variance is
  /// The amplitudes' posterior covariance is root root^T, n x (columns whose variance is not zero).
  Eigen::MatrixXd root;
  double log_evidence = 0.0;  ///< ln N(y; 0, Sigma + A Gamma A^T)
};
/// @pre variances not negative.
EvidencePosterior posterior(const EvidenceProblem& problem, const Eigen::VectorXd& group_variance);

/// Raises the evidence by `updates` of all variances, gamma_j = |a_j| / sqrt(tr A_j^T M^-1 A_j), M = Sigma +
/// A Gamma A^T (each update lowers a convex bound; none lowers the evidence). Groups whose variance falls
/// below `gone` times the largest are given zero, and stay there: the work falls with the cube of those left.
/// Cancelled: what it was until then.
Eigen::VectorXd maximise_evidence(const EvidenceProblem& problem, Eigen::VectorXd group_variance, int updates,
                                  double gone = 1e-9, const RunContext& context = {});

/// Gives zero to groups that add less than `price` to the log evidence, the one that adds least first, and
/// raises the others' variances again after each. What a group adds follows from the densities of its
/// amplitudes at zero, before over after the observations (Dickey 1971). Cancelled: as it is by then.
/// @param price nats.
Eigen::VectorXd keep_worth(const EvidenceProblem& problem, Eigen::VectorXd group_variance, double price,
                           const RunContext& context = {});

/// What each group adds to the log evidence, nats; 0 where its variance is.
Eigen::VectorXd evidence_of_groups(const EvidenceProblem& problem, const Eigen::VectorXd& group_variance);

}  // namespace glisson::registration
