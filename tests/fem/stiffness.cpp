// SPDX-License-Identifier: GPL-3.0-or-later
#include "stiffness.h"

#include "block_matrix.h"
#include "external_loads.h"
#include "glisson/core/error.h"

namespace glisson::fem {
namespace {

Eigen::SparseMatrix<double> by_node(const BlockSystem& system) {
  const BlockPattern& p = system.pattern();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(p.block_count()) * 18);
  for (int c = 0; c < p.unknowns; ++c)
    for (int b = p.column_start[static_cast<std::size_t>(c)];
         b < p.column_start[static_cast<std::size_t>(c) + 1]; ++b) {
      const int r = p.rows[static_cast<std::size_t>(b)];
      const int i = 3 * p.node_of_unknown[static_cast<std::size_t>(r)];
      const int j = 3 * p.node_of_unknown[static_cast<std::size_t>(c)];
      const double* block = system.values().data() + 9 * static_cast<std::ptrdiff_t>(b);
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) {
          entries.emplace_back(i + l, j + k, block[3 * k + l]);
          if (r != c) entries.emplace_back(j + k, i + l, block[3 * k + l]);
        }
    }
  Eigen::SparseMatrix<double> matrix(3 * p.unknowns, 3 * p.unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Eigen::SparseMatrix<double> stiffness_matrix(const CompositeModel& model, const Points& x, Tangent kind) {
  require(x.rows() == model.node_count(), "positions hold one row a node of the model");
  BlockSystem system(model.impl(), {});
  Points force;
  system.assemble(x, 1.0, kind, force);
  return by_node(system);
}

Points external_force(const CompositeModel& model, const Loads& loads, const Points& x) {
  require(x.rows() == model.node_count(), "positions hold one row a node of the model");
  check_loads(model.impl(), loads);
  Points force = Points::Zero(x.rows(), 3);
  add_external_force(model.impl(), loads, x, force);
  return force;
}

Eigen::SparseMatrix<double> load_stiffness_matrix(const CompositeModel& model, const Loads& loads,
                                                  const Points& x, Tangent kind) {
  require(x.rows() == model.node_count(), "positions hold one row a node of the model");
  check_loads(model.impl(), loads);
  BlockSystem system(model.impl(), {});
  add_external_tangent(model.impl(), loads, x, kind, system);
  return by_node(system);
}

}  // namespace glisson::fem
