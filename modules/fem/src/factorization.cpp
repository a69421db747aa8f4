// SPDX-License-Identifier: GPL-3.0-or-later
#include "factorization.h"

#include "cholmod_factorization.h"
#include "glisson/core/error.h"
#include "multifrontal_factorization.h"

namespace glisson::fem {

std::unique_ptr<Factorization> make_factorization(LinearSolver solver, const BlockPattern& pattern,
                                                  int threads) {
  if (solver == LinearSolver::reference) return std::make_unique<CholmodFactorization>(pattern);
  require(solver == LinearSolver::direct, "the fast solver has no factor of the whole matrix");
  return std::make_unique<MultifrontalFactorization>(pattern, threads);
}

}  // namespace glisson::fem
