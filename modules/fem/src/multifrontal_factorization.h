// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dense_kernels.h"
#include "factorization.h"
#include "front_tree.h"

namespace glisson::fem {

/// Multifrontal L L^T (Duff and Reid 1983) on 3 x 3 blocks: the matrix's columns go into dense fronts, each
/// is factorised in part, what remains is added to its parent. One thread, a fixed order of sums.
class MultifrontalFactorization : public Factorization {
 public:
  explicit MultifrontalFactorization(const BlockPattern& pattern,
                                     const DenseKernels& kernels = dense_kernels());
  bool factorise(const std::vector<double>& values) override;
  void solve(Eigen::VectorXd& b) override;

 private:
  /// A run of rows that stay neighbours in the parent.
  struct Run {
    int from, to, length;  ///< scalars
  };
  struct Layout {
    int columns, rows;         ///< scalars
    int stride, stride_schur;  ///< multiples of 8
    std::size_t panel, schur;  ///< offsets
    std::size_t runs, run_count;
  };
  void load_panel(std::size_t f, const std::vector<double>& values);
  void add_child(std::size_t child, std::size_t parent);

  const DenseKernels& kernels_;
  std::vector<Front> fronts_;
  std::vector<Layout> layouts_;
  std::vector<Run> runs_;
  std::vector<int> block_start_;            ///< of each front, in the matrix's blocks
  std::vector<std::size_t> block_targets_;  ///< where each block of the matrix goes in panels_
  std::vector<double> panels_, schur_;
  std::vector<double> below_;
};

}  // namespace glisson::fem
