// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "block_matrix.h"
#include "glisson/fem/integrator.h"

namespace glisson::fem {

/// One row an unknown (3 a node), one column a right-hand side.
using RightHandSides = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A = L L^T of the block matrix: the symbolic part once, at construction, the numbers every step.
class Factorization {
 public:
  virtual ~Factorization() = default;
  /// @return false when the matrix is not positive definite.
  virtual bool factorise(const std::vector<double>& values) = 0;
  /// In place, over unknowns in the pattern's order (3 a node). @pre factorise() succeeded.
  virtual void solve(Eigen::VectorXd& b) = 0;
  /// Many right-hand sides at once, one a column. @pre as above.
  virtual void solve_many(RightHandSides& b);
};

/// @param threads of `direct`, 1 or 2: the same bits.
std::unique_ptr<Factorization> make_factorization(LinearSolver solver, const BlockPattern& pattern,
                                                  int threads = 1);

}  // namespace glisson::fem
