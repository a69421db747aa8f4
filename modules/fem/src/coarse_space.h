// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "block_matrix.h"
#include "multifrontal_factorization.h"

namespace glisson::fem {

/// A coarse space for the system of one model: displacements that are linear in the tetrahedra of a regular
/// lattice around the rest shape (each cell cut in six, Kuhn's way). Every affine motion is in it. Its matrix
/// is P^T A P, factorised afresh for every A.
class CoarseSpace {
 public:
  /// @param rest node positions, one row a node. @param wanted number of lattice nodes, about.
  CoarseSpace(const BlockPattern& fine, const Points& rest, int wanted);

  int size() const { return pattern_.unknowns; }
  /// Takes over P^T A P. @return false when A is not positive definite there.
  bool factorise(const std::vector<double>& fine_values);
  /// e = P (P^T A P)^-1 P^T r; vectors hold four doubles a node, the fourth zero.
  void correct(const double* r, double* e);

 private:
  struct Support {
    std::array<int, 4> nodes{-1, -1, -1, -1};  ///< of the lattice, in the coarse matrix's order
    std::array<double, 4> weights{};
  };
  /// Where a product goes: the coarse block, and how.
  struct Target {
    int block;
    enum Kind : int { as_it_is, transposed, both } kind;
  };
  /// A fine column's products with P^T: how many lattice nodes they touch, and where each goes.
  struct Column {
    int touched;
    std::size_t first_target;
  };
  void place(const BlockPattern& fine, const Points& rest, double cell, std::vector<Support>& supports,
             int* count) const;
  void build_pattern(const BlockPattern& fine, int count);
  void build_targets(const BlockPattern& fine);

  const BlockPattern& fine_;
  std::vector<Support> supports_;  ///< of each fine unknown
  BlockPattern pattern_;
  std::vector<std::array<unsigned char, 4>> places_;  ///< of each fine block: its lattice nodes in the column
  std::vector<Column> columns_;
  std::vector<Target> targets_;
  std::vector<double> values_, products_;
  std::unique_ptr<MultifrontalFactorization> factorization_;
  Eigen::VectorXd right_;
};

}  // namespace glisson::fem
