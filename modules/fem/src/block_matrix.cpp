// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_matrix.h"

#include <Eigen/Dense>
#include <algorithm>
#include <string>

#include "glisson/core/error.h"
#include "ordering.h"

namespace glisson::fem {
namespace {

/// Free nodes that share an element, both ways, ascending.
std::vector<std::vector<int>> neighbours_of(const CompositeModel::Impl& model,
                                            const std::vector<int>& free_of_node, int free_count) {
  std::vector<std::vector<int>> lists(static_cast<std::size_t>(free_count));
  const auto couple = [&](int i, int j) {
    const int a = free_of_node[static_cast<std::size_t>(i)], b = free_of_node[static_cast<std::size_t>(j)];
    if (a >= 0 && b >= 0 && a != b) lists[static_cast<std::size_t>(a)].push_back(b);
  };
  for (const Tetrahedron& e : model.tetrahedra)
    for (const int i : e.nodes)
      for (const int j : e.nodes) couple(i, j);
  for (const VesselBeam& beam : model.vessels.beams) {
    const auto nodes_of = [&](int bound) -> const std::array<int, 4>& {
      const int t = model.vessels.nodes[static_cast<std::size_t>(bound)].tetrahedron;
      return model.tetrahedra[static_cast<std::size_t>(t)].nodes;
    };
    for (const int i : nodes_of(beam.a))
      for (const int j : nodes_of(beam.b)) {
        couple(i, j);
        couple(j, i);
      }
  }
  for (auto& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return lists;
}

BlockPattern make_pattern(const CompositeModel::Impl& model, const std::vector<int>& fixed_nodes) {
  const int n = model.mesh.vertex_count();
  BlockPattern p;
  std::vector<int> free_of_node(static_cast<std::size_t>(n), 0), node_of_free;
  for (const int node : fixed_nodes) {
    if (node < 0 || node >= n)
      throw InputError("fixed_nodes", std::to_string(node), "is not a node of the mesh",
                       "Give 0-based indices below " + std::to_string(n));
    free_of_node[static_cast<std::size_t>(node)] = -1;
  }
  for (int node = 0; node < n; ++node)
    if (free_of_node[static_cast<std::size_t>(node)] >= 0) {
      free_of_node[static_cast<std::size_t>(node)] = static_cast<int>(node_of_free.size());
      node_of_free.push_back(node);
    }
  if (node_of_free.empty())
    throw InputError("fixed_nodes", "", "fix every node of the mesh", "Leave some free to move");
  p.unknowns = static_cast<int>(node_of_free.size());
  const auto neighbours = neighbours_of(model, free_of_node, p.unknowns);
  const std::vector<int> order = fill_reducing_order(neighbours);
  std::vector<int> unknown_of_free(order.size());
  p.node_of_unknown.resize(order.size());
  p.unknown_of_node.assign(static_cast<std::size_t>(n), -1);
  for (int u = 0; u < p.unknowns; ++u) {
    const auto free = static_cast<std::size_t>(order[static_cast<std::size_t>(u)]);
    unknown_of_free[free] = u;
    p.node_of_unknown[static_cast<std::size_t>(u)] = node_of_free[free];
    p.unknown_of_node[static_cast<std::size_t>(node_of_free[free])] = u;
  }
  p.column_start.push_back(0);
  for (int u = 0; u < p.unknowns; ++u) {
    const std::size_t first = p.rows.size();
    p.rows.push_back(u);
    for (const int j : neighbours[static_cast<std::size_t>(order[static_cast<std::size_t>(u)])])
      if (const int v = unknown_of_free[static_cast<std::size_t>(j)]; v > u) p.rows.push_back(v);
    std::sort(p.rows.begin() + static_cast<std::ptrdiff_t>(first), p.rows.end());
    p.column_start.push_back(static_cast<int>(p.rows.size()));
  }
  return p;
}

}  // namespace

int BlockPattern::find(int row, int column) const {
  const auto first = rows.begin() + column_start[static_cast<std::size_t>(column)];
  const auto last = rows.begin() + column_start[static_cast<std::size_t>(column) + 1];
  const auto at = std::lower_bound(first, last, row);
  return at != last && *at == row ? static_cast<int>(at - rows.begin()) : -1;
}

BlockSystem::BlockSystem(const CompositeModel::Impl& model, const std::vector<int>& fixed_nodes)
    : model_(model), pattern_(make_pattern(model, fixed_nodes)) {
  values_.assign(static_cast<std::size_t>(pattern_.block_count()) * 9, 0.0);
  for (const Tetrahedron& e : model_.tetrahedra) {
    auto& slots = tetrahedron_slots_.emplace_back();
    int k = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j <= i; ++j) slots[static_cast<std::size_t>(k++)] = slot(e.nodes[i], e.nodes[j]);
  }
  for (const Membrane& e : model_.membranes) {
    auto& slots = membrane_slots_.emplace_back();
    int k = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) slots[static_cast<std::size_t>(k++)] = slot(e.nodes[i], e.nodes[j]);
  }
}

int BlockSystem::slot(int node_i, int node_j) const {
  const int i = pattern_.unknown_of_node[static_cast<std::size_t>(node_i)];
  const int j = pattern_.unknown_of_node[static_cast<std::size_t>(node_j)];
  if (i < 0 || j < 0) return -1;
  const int index = pattern_.find(std::max(i, j), std::min(i, j));
  if (index < 0)
    throw PreconditionError(
        "An attached load couples nodes " + std::to_string(node_i) + " and " + std::to_string(node_j) +
        ", which share no element; attach it to the nodes of one tetrahedron or triangle.");
  return 2 * index + (i < j ? 1 : 0);
}

void BlockSystem::add_to_slot(int code, const Eigen::Matrix3d& block) {
  if (code < 0) return;
  Eigen::Map<Eigen::Matrix3d> target(values_.data() + static_cast<std::ptrdiff_t>(code >> 1) * 9);
  if (code & 1)
    target += block.transpose();
  else
    target += block;
}

void BlockSystem::add(int node_i, int node_j, const Eigen::Matrix3d& block) {
  add_to_slot(slot(node_i, node_j), block);
}

void BlockSystem::add_diagonal(const Eigen::VectorXd& per_node, double scale) {
  for (int u = 0; u < pattern_.unknowns; ++u) {
    double* block =
        values_.data() + static_cast<std::ptrdiff_t>(pattern_.column_start[static_cast<std::size_t>(u)]) * 9;
    const double value = scale * per_node[pattern_.node_of_unknown[static_cast<std::size_t>(u)]];
    block[0] += value;
    block[4] += value;
    block[8] += value;
  }
}

void BlockSystem::assemble(const Points& x, double scale, Tangent kind, Points& force) {
  std::fill(values_.begin(), values_.end(), 0.0);
  force.setZero(x.rows(), 3);
  add_tetrahedra(x, scale, kind, force);
  add_membranes(x, scale, kind, force);
  add_beams(x, scale, force);
}

void BlockSystem::add_tetrahedra(const Points& x, double scale, Tangent kind, Points& force) {
  const TetrahedronLaw law = model_.options.law;
  for (std::size_t t = 0; t < model_.tetrahedra.size(); ++t) {
    const Tetrahedron& e = model_.tetrahedra[t];
    const Eigen::Matrix3d f = e.deformation_gradient(x);
    const Eigen::Matrix<double, 3, 4> forces = e.volume * stress(e, law, f) * e.gradients;
    for (int k = 0; k < 4; ++k) force.row(e.nodes[k]) -= forces.col(k).transpose();
    const Eigen::Matrix<double, 12, 12> k = scale * tangent(e, law, f, kind);
    int s = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j <= i; ++j)
        add_to_slot(tetrahedron_slots_[t][static_cast<std::size_t>(s++)], k.block<3, 3>(3 * i, 3 * j));
  }
}

void BlockSystem::add_membranes(const Points& x, double scale, Tangent kind, Points& force) {
  for (std::size_t t = 0; t < model_.membranes.size(); ++t) {
    const Membrane& e = model_.membranes[t];
    const Eigen::Matrix<double, 3, 2> f = e.deformation_gradient(x);
    const Eigen::Matrix3d forces = e.volume * stress(e, f) * e.gradients;
    for (int k = 0; k < 3; ++k) force.row(e.nodes[k]) -= forces.col(k).transpose();
    const Eigen::Matrix<double, 9, 9> k = scale * tangent(e, f, kind);
    int s = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        add_to_slot(membrane_slots_[t][static_cast<std::size_t>(s++)], k.block<3, 3>(3 * i, 3 * j));
  }
}

void BlockSystem::add_beams(const Points& x, double scale, Points& force) {
  const VesselBeams& vessels = model_.vessels;
  const std::vector<BoundState> states = bound_states(vessels, model_.tetrahedra, x);
  for (const VesselBeam& beam : vessels.beams) {
    const BeamElement::Rows rows =
        std::sqrt(scale) * beam.element.stiffness_rows(states[static_cast<std::size_t>(beam.a)].state,
                                                       states[static_cast<std::size_t>(beam.b)].state);
    const BeamElement::Gradient gradient = beam.element.gradient(
        states[static_cast<std::size_t>(beam.a)].state, states[static_cast<std::size_t>(beam.b)].state);
    std::array<int, 8> nodes{};
    std::array<Eigen::Matrix<double, 6, 3>, 8> columns;  // rows J, a node
    std::size_t count = 0;
    for (int end = 0; end < 2; ++end) {
      const int index = end == 0 ? beam.a : beam.b;
      const BoundNode& node = vessels.nodes[static_cast<std::size_t>(index)];
      const BoundState& bound = states[static_cast<std::size_t>(index)];
      add_bound_force(node, model_.tetrahedra, bound, gradient.segment<6>(6 * end), force);
      const auto& tetrahedron = model_.tetrahedra[static_cast<std::size_t>(node.tetrahedron)].nodes;
      for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Matrix<double, 6, 3> column =
            node.weights[static_cast<Eigen::Index>(i)] * rows.block<6, 3>(0, 6 * end) +
            rows.block<6, 3>(0, 6 * end + 3) * bound.turn[i];
        const auto at =
            std::find(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(count), tetrahedron[i]) -
            nodes.begin();
        const auto place = static_cast<std::size_t>(at);
        if (place < count) {
          columns[place] += column;
        } else {
          nodes[count] = tetrahedron[i];
          columns[count++] = column;
        }
      }
    }
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j <= i; ++j) add(nodes[i], nodes[j], columns[i].transpose() * columns[j]);
  }
}

void BlockSystem::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  y.setZero(x.size());
  for (int c = 0; c < pattern_.unknowns; ++c) {
    const Eigen::Vector3d xc = x.segment<3>(3 * c);
    Eigen::Vector3d yc = Eigen::Vector3d::Zero();
    const int first = pattern_.column_start[static_cast<std::size_t>(c)];
    const int last = pattern_.column_start[static_cast<std::size_t>(c) + 1];
    for (int k = first; k < last; ++k) {
      const Eigen::Map<const Eigen::Matrix3d> block(values_.data() + static_cast<std::ptrdiff_t>(k) * 9);
      const int r = pattern_.rows[static_cast<std::size_t>(k)];
      if (k == first) {
        yc += block * xc;
      } else {
        y.segment<3>(3 * r) += block * xc;
        yc += block.transpose() * x.segment<3>(3 * r);
      }
    }
    y.segment<3>(3 * c) += yc;
  }
}

Eigen::VectorXd BlockSystem::gather(const Points& per_node) const {
  Eigen::VectorXd vector(3 * pattern_.unknowns);
  for (int u = 0; u < pattern_.unknowns; ++u)
    vector.segment<3>(3 * u) =
        per_node.row(pattern_.node_of_unknown[static_cast<std::size_t>(u)]).transpose();
  return vector;
}

}  // namespace glisson::fem
