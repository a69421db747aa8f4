// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "companion.h"
#include "dense_kernels.h"
#include "factorization.h"
#include "front_tree.h"

namespace glisson::fem {

/// Multifrontal L L^T (Duff and Reid 1983) on 3 x 3 blocks: the matrix's columns go into dense fronts, each
/// is factorised in part, what remains is added to its parent. A fixed order of sums, whatever the threads.
class MultifrontalFactorization : public Factorization {
 public:
  /// @param threads 1, or 2: each takes whole subtrees, and half of the rows of the fronts above them. A
  ///   small matrix is worked on by one thread all the same.
  explicit MultifrontalFactorization(const BlockPattern& pattern, int threads = 1,
                                     const DenseKernels& kernels = dense_kernels());
  bool factorise(const std::vector<double>& values) override;
  void solve(Eigen::VectorXd& b) override;
  /// By one thread, some columns at a time; subtrees whose right-hand sides are zero are left out.
  void solve_many(RightHandSides& b) override;
  int threads() const { return companion_ ? 2 : 1; }

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
  bool factorise_front(int front, const std::vector<double>& values, bool shared);
  /// @return false: not positive definite.
  bool factor_panel(const Layout& layout, bool shared);
  void subtract_product(const Layout& layout, bool shared);
  void solve_chunk(RightHandSides& b, Eigen::Index first, std::vector<double>& rows);
  void backward(const std::vector<int>& group, Eigen::VectorXd& x, std::vector<double>& below);
  /// Work on rows [from, to), multiples of 8, in two halves when it is `worth` it.
  template <class Work>
  void by_rows(bool shared, int from, int to, double worth, const Work& work);

  const DenseKernels& kernels_;
  std::vector<Front> fronts_;
  FrontGroups groups_;
  std::unique_ptr<Companion> companion_;  ///< null: one thread
  std::vector<Layout> layouts_;
  std::vector<Run> runs_;
  std::vector<int> block_start_;            ///< of each front, in the matrix's blocks
  std::vector<std::size_t> block_targets_;  ///< where each block of the matrix goes in panels_
  std::vector<double> panels_, schur_;
  std::vector<double> below_, below_theirs_;
};

}  // namespace glisson::fem
