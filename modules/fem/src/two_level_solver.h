// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "coarse_space.h"
#include "sweep_kernels.h"

namespace glisson::fem {

/// Conjugate gradients on the block matrix, preconditioned by one symmetric two-level cycle: a Gauss-Seidel
/// sweep down, the lattice's correction, a sweep up. Everything is computed afresh from the matrix: no lag,
/// so a result depends on nothing but the state.
class TwoLevelSolver {
 public:
  /// @param fine kept by reference, in an order that keeps neighbours together.
  TwoLevelSolver(const BlockPattern& fine, const Points& rest, const SweepKernels& kernels = sweep_kernels());

  /// @return false when the matrix is not positive definite.
  bool prepare(const std::vector<double>& values);
  struct Result {
    bool converged = false;
    int iterations = 0;
    double residual = 0.0;  ///< |b - A x| / |b|, computed from x at the end
  };
  /// Improves x until |b - A x| <= tolerance |b|. Vectors over unknowns, three a node. @pre prepare()
  /// succeeded, and its values are still there.
  Result solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance, int max_iterations);

 private:
  void precondition();
  void subtract(const Eigen::VectorXd& x, Eigen::VectorXd& r) const;

  const BlockPattern& fine_;
  const SweepKernels& kernels_;
  CoarseSpace coarse_;
  const double* values_ = nullptr;
  std::vector<double> inverse_;
  // Four doubles a node: solution, residual, direction d, A d, z, A z, and what a cycle needs.
  Eigen::VectorXd x_, r_, d_, q_, z_, az_, work_, left_, sweep_;
};

}  // namespace glisson::fem
