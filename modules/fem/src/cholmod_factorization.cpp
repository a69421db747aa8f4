// SPDX-License-Identifier: GPL-3.0-or-later
#include "cholmod_factorization.h"

#include <algorithm>

#include "glisson/core/error.h"

extern "C" void openblas_set_num_threads(int);

namespace glisson::fem {

CholmodFactorization::CholmodFactorization(const BlockPattern& pattern) {
  cholmod_start(&common_);
  // The pattern's own order, as for every solver, so that they differ in arithmetic alone.
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_NATURAL;
  common_.postorder = true;
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.print = 0;
  const auto n = static_cast<std::size_t>(pattern.unknowns) * 3;
  const std::size_t count =
      static_cast<std::size_t>(pattern.block_count()) * 9 - static_cast<std::size_t>(pattern.unknowns) * 3;
  matrix_ = cholmod_allocate_sparse(n, n, count, true, true, -1, CHOLMOD_REAL, &common_);
  if (matrix_ == nullptr) throw NumericalError("Out of memory for the mechanics' matrix.");
  auto* start = static_cast<int*>(matrix_->p);
  auto* rows = static_cast<int*>(matrix_->i);
  source_.reserve(count);
  for (int c = 0; c < pattern.unknowns; ++c)
    for (int k = 0; k < 3; ++k) {
      start[3 * c + k] = static_cast<int>(source_.size());
      for (int b = pattern.column_start[static_cast<std::size_t>(c)];
           b < pattern.column_start[static_cast<std::size_t>(c) + 1]; ++b)
        for (int i = 0; i < 3; ++i) {
          const int row = 3 * pattern.rows[static_cast<std::size_t>(b)] + i;
          if (row < 3 * c + k) continue;
          rows[source_.size()] = row;
          source_.push_back(9 * b + 3 * k + i);
        }
    }
  start[n] = static_cast<int>(source_.size());
  factor_ = cholmod_analyze(matrix_, &common_);
  if (factor_ == nullptr) throw NumericalError("The analysis of the mechanics' matrix failed.");
}

CholmodFactorization::~CholmodFactorization() {
  cholmod_free_dense(&solution_, &common_);
  cholmod_free_dense(&work_y_, &common_);
  cholmod_free_dense(&work_e_, &common_);
  cholmod_free_factor(&factor_, &common_);
  cholmod_free_sparse(&matrix_, &common_);
  cholmod_finish(&common_);
}

bool CholmodFactorization::factorise(const std::vector<double>& values) {
  openblas_set_num_threads(1);  // more would change the order of sums, and pay nothing at this size
  auto* target = static_cast<double*>(matrix_->x);
  for (std::size_t k = 0; k < source_.size(); ++k) target[k] = values[static_cast<std::size_t>(source_[k])];
  return cholmod_factorize(matrix_, factor_, &common_) && common_.status == CHOLMOD_OK &&
         factor_->minor == factor_->n;
}

void CholmodFactorization::solve(Eigen::VectorXd& b) {
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = static_cast<std::size_t>(b.size());
  right.ncol = 1;
  right.x = b.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_solve2(CHOLMOD_A, factor_, &right, nullptr, &solution_, nullptr, &work_y_, &work_e_, &common_);
  std::copy_n(static_cast<const double*>(solution_->x), b.size(), b.data());
}

}  // namespace glisson::fem
