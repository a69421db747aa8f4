// SPDX-License-Identifier: GPL-3.0-or-later
#include "factorization.h"

#include "cholmod_factorization.h"
#include "glisson/core/error.h"
#include "multifrontal_factorization.h"

namespace glisson::fem {

void Factorization::solve_many(RightHandSides& b) {
  Eigen::VectorXd column;
  for (Eigen::Index k = 0; k < b.cols(); ++k) {
    column = b.col(k);
    solve(column);
    b.col(k) = column;
  }
}

std::unique_ptr<Factorization> make_factorization(LinearSolver solver, const BlockPattern& pattern,
                                                  int threads) {
  if (solver == LinearSolver::reference) return std::make_unique<CholmodFactorization>(pattern);
  require(solver == LinearSolver::direct, "the fast solver has no factor of the whole matrix");
  return std::make_unique<MultifrontalFactorization>(pattern, threads);
}

}  // namespace glisson::fem
