// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

#include <vector>

#include "factorization.h"

namespace glisson::fem {

/// SuiteSparse's supernodal L L^T on OpenBLAS with one thread: the reference.
class CholmodFactorization : public Factorization {
 public:
  explicit CholmodFactorization(const BlockPattern& pattern);
  ~CholmodFactorization() override;
  CholmodFactorization(const CholmodFactorization&) = delete;
  CholmodFactorization& operator=(const CholmodFactorization&) = delete;
  bool factorise(const std::vector<double>& values) override;
  void solve(Eigen::VectorXd& b) override;

 private:
  cholmod_common common_{};
  cholmod_sparse* matrix_ = nullptr;
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *solution_ = nullptr, *work_y_ = nullptr, *work_e_ = nullptr;
  std::vector<int> source_;  ///< of each scalar entry, in the block values
};

}  // namespace glisson::fem
