// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "batch_kernels.h"
#include "composite_impl.h"

namespace glisson::fem {

/// Which 3 x 3 blocks of the lower triangle are there. Unknown = a free node's place in the elimination
/// order.
struct BlockPattern {
  int unknowns = 0;
  std::vector<int> unknown_of_node;  ///< -1: the node is fixed
  std::vector<int> node_of_unknown;
  std::vector<int> column_start;  ///< unknowns + 1
  std::vector<int> rows;          ///< ascending in a column, the diagonal first

  int block_count() const { return static_cast<int>(rows.size()); }
  /// Index of the block (row >= column), or -1.
  int find(int row, int column) const;
};

/// What the unknowns' order is for: little fill in a factor, or neighbours side by side.
enum class Ordering { fill_reducing, breadth_first };

/// The pattern of nodes that are coupled: (i, j) of `couplings`, one way or both, fixed ones left out.
/// @throws InputError for fixed nodes out of range or when all are fixed.
BlockPattern make_pattern(int nodes, const std::vector<std::array<int, 2>>& couplings,
                          const std::vector<int>& fixed_nodes, Ordering ordering);

/// The system matrix of one model with given fixed nodes: its pattern (tetrahedra's edges, couplings by
/// beams) and the places of every element's blocks in it, found once.
class BlockSystem {
 public:
  using Block = Eigen::Matrix3d;

  /// @throws InputError for fixed nodes out of range or when all are fixed.
  BlockSystem(const CompositeModel::Impl& model, const std::vector<int>& fixed_nodes,
              const BatchKernels& kernels = batch_kernels(), Ordering ordering = Ordering::fill_reducing);

  const BlockPattern& pattern() const { return pattern_; }
  /// Column-major 3 x 3 blocks in the pattern's order (and a spare one behind them).
  const std::vector<double>& values() const { return values_; }

  /// Sets the matrix to `scale` times the model's tangent at x, and `force` (all nodes) to the internal
  /// force.
  void assemble(const Points& x, double scale, Tangent kind, Points& force);
  /// Adds `scale` times the model's mass matrix.
  void add_mass(double scale);
  /// Adds to the diagonal blocks: `scale` times one value a node.
  void add_diagonal(const Eigen::VectorXd& per_node, double scale);
  /// Adds a block that couples two nodes (node indices), and its mirror image. Blocks of fixed nodes vanish.
  /// @throws PreconditionError when the pattern does not hold it.
  void add(int node_i, int node_j, const Eigen::Matrix3d& block);
  /// y = A x, over unknowns (3 a node).
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const { multiply(values_, x, y); }
  /// The same with values that were kept.
  void multiply(const std::vector<double>& values, const Eigen::VectorXd& x, Eigen::VectorXd& y) const;

  Eigen::VectorXd gather(const Points& per_node) const;
  /// Back to all nodes; zero on fixed ones.
  Points scatter(const Eigen::VectorXd& x) const;

 private:
  /// The 3 x 3 blocks that a beam couples: those of its two tetrahedra's nodes.
  struct BeamCoupling {
    int count = 0;
    std::array<int, 8> nodes{};  ///< in the order of their unknowns
    std::array<int, 8> place{};  ///< in nodes, of the first and the second tetrahedron's four
    std::array<int, 36> blocks{};
  };
  int block_of(int node_i, int node_j) const;
  void build_groups();
  void build_couplings();
  void build_mass();
  void add_tetrahedra(const Points& x, double scale, Tangent kind, Points& force);
  void add_membranes(const Points& x, double scale, Tangent kind, Points& force);
  void add_beams(const Points& x, double scale, Tangent kind, Points& force);
  void add_exact_beam(std::size_t beam, const std::array<const BoundState*, 2>& ends, const Points& x,
                      double scale, Points& force);

  const CompositeModel::Impl& model_;
  const BatchKernels& kernels_;
  BlockPattern pattern_;
  std::vector<double> values_;  ///< and a spare block behind them, where the fixed nodes' go
  std::vector<TetrahedronGroup> tetrahedron_groups_;
  std::vector<MembraneGroup> membrane_groups_;
  std::vector<BeamCoupling> couplings_;
  std::vector<double> block_mass_;  ///< kg, one a block, where the mass is consistent
};

}  // namespace glisson::fem
