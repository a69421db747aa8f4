// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_matrix.h"

#include <Eigen/Dense>
#include <algorithm>
#include <string>

#include "glisson/core/error.h"
#include "ordering.h"

namespace glisson::fem {
namespace {

/// Nodes that share an element or a beam.
std::vector<std::array<int, 2>> couplings_of(const CompositeModel::Impl& model) {
  std::vector<std::array<int, 2>> couplings;
  for (const Tetrahedron& e : model.tetrahedra)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) couplings.push_back({e.nodes[i], e.nodes[j]});
  for (const VesselBeam& beam : model.vessels.beams) {
    const auto nodes_of = [&](int bound) -> const std::array<int, 4>& {
      const int t = model.vessels.nodes[static_cast<std::size_t>(bound)].tetrahedron;
      return model.tetrahedra[static_cast<std::size_t>(t)].nodes;
    };
    for (const int i : nodes_of(beam.a))
      for (const int j : nodes_of(beam.b)) couplings.push_back({i, j});
  }
  return couplings;
}

/// Free nodes that are coupled, both ways, ascending.
std::vector<std::vector<int>> neighbours_of(const std::vector<std::array<int, 2>>& couplings,
                                            const std::vector<int>& free_of_node, int free_count) {
  std::vector<std::vector<int>> lists(static_cast<std::size_t>(free_count));
  for (const auto& [i, j] : couplings) {
    const int a = free_of_node[static_cast<std::size_t>(i)], b = free_of_node[static_cast<std::size_t>(j)];
    if (a < 0 || b < 0 || a == b) continue;
    lists[static_cast<std::size_t>(a)].push_back(b);
    lists[static_cast<std::size_t>(b)].push_back(a);
  }
  for (auto& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return lists;
}

}  // namespace

BlockPattern make_pattern(int n, const std::vector<std::array<int, 2>>& couplings,
                          const std::vector<int>& fixed_nodes, Ordering ordering) {
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
  const auto neighbours = neighbours_of(couplings, free_of_node, p.unknowns);
  const std::vector<int> order =
      ordering == Ordering::fill_reducing ? fill_reducing_order(neighbours) : breadth_first_order(neighbours);
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

int BlockPattern::find(int row, int column) const {
  const auto first = rows.begin() + column_start[static_cast<std::size_t>(column)];
  const auto last = rows.begin() + column_start[static_cast<std::size_t>(column) + 1];
  const auto at = std::lower_bound(first, last, row);
  return at != last && *at == row ? static_cast<int>(at - rows.begin()) : -1;
}

BlockSystem::BlockSystem(const CompositeModel::Impl& model, const std::vector<int>& fixed_nodes,
                         const BatchKernels& kernels, Ordering ordering)
    : model_(model),
      kernels_(kernels),
      pattern_(make_pattern(model.mesh.vertex_count(), couplings_of(model), fixed_nodes, ordering)) {
  values_.assign(static_cast<std::size_t>(pattern_.block_count() + 1) * 9, 0.0);
  build_groups();
  build_couplings();
  if (model.options.mass == MassMatrix::consistent) build_mass();
}

int BlockSystem::block_of(int node_i, int node_j) const {
  const int i = pattern_.unknown_of_node[static_cast<std::size_t>(node_i)];
  const int j = pattern_.unknown_of_node[static_cast<std::size_t>(node_j)];
  if (i < 0 || j < 0) return pattern_.block_count();
  const int index = pattern_.find(std::max(i, j), std::min(i, j));
  if (index < 0)
    throw PreconditionError(
        "An attached load couples nodes " + std::to_string(node_i) + " and " + std::to_string(node_j) +
        ", which share no element; attach it to the nodes of one tetrahedron or triangle.");
  return index;
}

void BlockSystem::build_groups() {
  const auto by_unknown = [&](int a, int b) {
    return pattern_.unknown_of_node[static_cast<std::size_t>(a)] <
           pattern_.unknown_of_node[static_cast<std::size_t>(b)];
  };
  // Lanes beyond the last element: its nodes, no stiffness, the spare block.
  const auto fill = [&](auto& groups, std::size_t number, const auto& element, bool padding) {
    constexpr auto kNodes = std::tuple_size_v<std::remove_cvref_t<decltype(element.nodes)>>;
    if (number % kLanes == 0) groups.emplace_back();
    auto& group = groups.back();
    const std::size_t lane = number % kLanes;
    std::array<std::size_t, kNodes> order;
    for (std::size_t k = 0; k < kNodes; ++k) order[k] = k;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return by_unknown(element.nodes[a], element.nodes[b]); });
    group.lambda[lane] = padding ? 0.0 : element.volume * element.lambda;
    group.mu[lane] = padding ? 0.0 : element.volume * element.mu;
    std::size_t block = 0;
    for (std::size_t i = 0; i < kNodes; ++i) {
      const auto gi = element.gradients.col(static_cast<Eigen::Index>(order[i]));
      group.node[i][lane] = element.nodes[order[i]];
      if (i > 0)
        for (Eigen::Index r = 0; r < gi.rows(); ++r)
          group.gradients[(static_cast<Eigen::Index>(i) - 1) * gi.rows() + r][lane] = gi[r];
      for (std::size_t j = 0; j <= i; ++j, ++block) {
        group.dots[block][lane] =
            group.mu[lane] * gi.dot(element.gradients.col(static_cast<Eigen::Index>(order[j])));
        group.slot[block][lane] =
            padding ? pattern_.block_count() : block_of(element.nodes[order[i]], element.nodes[order[j]]);
      }
    }
  };
  // Elements in the order of their first unknowns: what they add to lies together.
  const auto fill_all = [&](auto& groups, const auto& elements) {
    std::vector<std::pair<int, std::size_t>> order;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const auto& nodes = elements[e].nodes;
      order.emplace_back(pattern_.unknown_of_node[static_cast<std::size_t>(
                             *std::min_element(nodes.begin(), nodes.end(), by_unknown))],
                         e);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t e = 0; e < elements.size(); ++e) fill(groups, e, elements[order[e].second], false);
    for (std::size_t e = elements.size(); e % kLanes != 0; ++e) fill(groups, e, elements.back(), true);
  };
  fill_all(tetrahedron_groups_, model_.tetrahedra);
  fill_all(membrane_groups_, model_.membranes);
}

void BlockSystem::build_couplings() {
  for (const VesselBeam& beam : model_.vessels.beams) {
    BeamCoupling coupling;
    std::array<int, 8> all{};
    for (int end = 0; end < 2; ++end) {
      const auto bound = static_cast<std::size_t>(end == 0 ? beam.a : beam.b);
      const auto t = static_cast<std::size_t>(model_.vessels.nodes[bound].tetrahedron);
      for (std::size_t k = 0; k < 4; ++k)
        all[static_cast<std::size_t>(4 * end) + k] = model_.tetrahedra[t].nodes[k];
    }
    coupling.nodes = all;
    const auto rank = [&](int node) { return pattern_.unknown_of_node[static_cast<std::size_t>(node)]; };
    std::sort(coupling.nodes.begin(), coupling.nodes.end(), [&](int a, int b) {
      return rank(a) != rank(b) ? rank(a) < rank(b) : a < b;  // fixed nodes all rank alike
    });
    coupling.count =
        static_cast<int>(std::unique(coupling.nodes.begin(), coupling.nodes.end()) - coupling.nodes.begin());
    for (std::size_t k = 0; k < 8; ++k)
      coupling.place[k] = static_cast<int>(
          std::find(coupling.nodes.begin(), coupling.nodes.begin() + coupling.count, all[k]) -
          coupling.nodes.begin());
    std::size_t slot = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(coupling.count); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        coupling.blocks[slot++] = block_of(coupling.nodes[i], coupling.nodes[j]);
    couplings_.push_back(coupling);
  }
}

void BlockSystem::add(int node_i, int node_j, const Eigen::Matrix3d& block) {
  Eigen::Map<Eigen::Matrix3d> target(values_.data() +
                                     static_cast<std::ptrdiff_t>(block_of(node_i, node_j)) * 9);
  if (pattern_.unknown_of_node[static_cast<std::size_t>(node_i)] <
      pattern_.unknown_of_node[static_cast<std::size_t>(node_j)])
    target += block.transpose();
  else
    target += block;
}

void BlockSystem::build_mass() {
  block_mass_.assign(static_cast<std::size_t>(pattern_.block_count()) + 1, 0.0);
  for (const Tetrahedron& e : model_.tetrahedra)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        block_mass_[static_cast<std::size_t>(block_of(e.nodes[i], e.nodes[j]))] +=
            model_.options.density * e.volume / (i == j ? 10.0 : 20.0);
}

void BlockSystem::add_mass(double scale) {
  if (block_mass_.empty()) {
    add_diagonal(model_.lumped_mass, scale);
    return;
  }
  for (std::size_t b = 0; b + 1 < block_mass_.size(); ++b)
    for (std::size_t k = 0; k < 9; k += 4) values_[9 * b + k] += scale * block_mass_[b];
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
  add_beams(x, scale, kind, force);
}

void BlockSystem::add_tetrahedra(const Points& x, double scale, Tangent kind, Points& force) {
  const TetrahedronLaw law = model_.options.law;
  if (law == TetrahedronLaw::corotational && kind == Tangent::rotated) {
    kernels_.tetrahedra(tetrahedron_groups_.data(), static_cast<int>(tetrahedron_groups_.size()), scale,
                        x.data(), values_.data(), force.data());
    return;
  }
  for (const Tetrahedron& e : model_.tetrahedra) {
    const Eigen::Matrix3d f = e.deformation_gradient(x);
    const Eigen::Matrix<double, 3, 4> forces = e.volume * stress(e, law, f) * e.gradients;
    for (int k = 0; k < 4; ++k) force.row(e.nodes[k]) -= forces.col(k).transpose();
    const Eigen::Matrix<double, 12, 12> k = scale * tangent(e, law, f, kind);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j <= i; ++j) add(e.nodes[i], e.nodes[j], k.block<3, 3>(3 * i, 3 * j));
  }
}

void BlockSystem::add_membranes(const Points& x, double scale, Tangent kind, Points& force) {
  if (kind == Tangent::rotated) {
    kernels_.membranes(membrane_groups_.data(), static_cast<int>(membrane_groups_.size()), scale, x.data(),
                       values_.data(), force.data());
    return;
  }
  for (const Membrane& e : model_.membranes) {
    const Eigen::Matrix<double, 3, 2> f = e.deformation_gradient(x);
    const Eigen::Matrix3d forces = e.volume * stress(e, f) * e.gradients;
    for (int k = 0; k < 3; ++k) force.row(e.nodes[k]) -= forces.col(k).transpose();
    const Eigen::Matrix<double, 9, 9> k = scale * tangent(e, f, kind);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) add(e.nodes[i], e.nodes[j], k.block<3, 3>(3 * i, 3 * j));
  }
}

void BlockSystem::add_exact_beam(std::size_t number, const std::array<const BoundState*, 2>& ends,
                                 const Points& x, double scale, Points& force) {
  const VesselBeams& vessels = model_.vessels;
  const VesselBeam& beam = vessels.beams[number];
  const BeamElement::Gradient gradient = beam.element.gradient(ends[0]->state, ends[1]->state);
  Eigen::Matrix<double, 12, 24> j = Eigen::Matrix<double, 12, 24>::Zero();
  const std::array<const BoundNode*, 2> nodes{&vessels.nodes[static_cast<std::size_t>(beam.a)],
                                              &vessels.nodes[static_cast<std::size_t>(beam.b)]};
  for (int end = 0; end < 2; ++end)
    for (int i = 0; i < 4; ++i) {
      const auto e = static_cast<std::size_t>(end);
      j.block<3, 3>(6 * end, 12 * end + 3 * i) = nodes[e]->weights[i] * Eigen::Matrix3d::Identity();
      j.block<3, 3>(6 * end + 3, 12 * end + 3 * i) = ends[e]->turn[static_cast<std::size_t>(i)];
    }
  Eigen::Matrix<double, 24, 24> k =
      j.transpose() * beam.element.gradient_rate(ends[0]->state, ends[1]->state) * j;
  for (int end = 0; end < 2; ++end) {
    const BoundNode& node = *nodes[static_cast<std::size_t>(end)];
    add_bound_force(node, model_.tetrahedra, *ends[static_cast<std::size_t>(end)],
                    gradient.segment<6>(6 * end), force);
    k.block<12, 12>(12 * end, 12 * end) +=
        binding_curvature(node, model_.tetrahedra[static_cast<std::size_t>(node.tetrahedron)], x,
                          gradient.segment<3>(6 * end + 3));
  }
  // Sorted into the blocks of the nodes that the two tetrahedra have together.
  const BeamCoupling& coupling = couplings_[number];
  Eigen::Matrix<double, 24, 24> together = Eigen::Matrix<double, 24, 24>::Zero();
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < 8; ++b)
      together.block<3, 3>(3 * coupling.place[static_cast<std::size_t>(a)],
                           3 * coupling.place[static_cast<std::size_t>(b)]) +=
          scale * k.block<3, 3>(3 * a, 3 * b);
  std::size_t slot = 0;
  for (int a = 0; a < coupling.count; ++a)
    for (int b = 0; b <= a; ++b)
      Eigen::Map<Eigen::Matrix3d>(values_.data() +
                                  9 * static_cast<std::ptrdiff_t>(coupling.blocks[slot++])) +=
          together.block<3, 3>(3 * a, 3 * b);
}

void BlockSystem::add_beams(const Points& x, double scale, Tangent kind, Points& force) {
  const VesselBeams& vessels = model_.vessels;
  const std::vector<BoundState> states = bound_states(vessels, model_.tetrahedra, x);
  const double root = std::sqrt(scale);
  for (std::size_t n = 0; n < vessels.beams.size(); ++n) {
    const VesselBeam& beam = vessels.beams[n];
    const BeamCoupling& coupling = couplings_[n];
    const BoundState &first = states[static_cast<std::size_t>(beam.a)],
                     &second = states[static_cast<std::size_t>(beam.b)];
    if (kind == Tangent::exact) {
      add_exact_beam(n, {&first, &second}, x, scale, force);
      continue;
    }
    BeamElement::Gradient gradient;
    BeamElement::Rows rows;
    beam.element.linearise(first.state, second.state, gradient, rows);
    std::array<Eigen::Matrix<double, 6, 3>, 8> columns;  // rows J, a node
    for (auto& column : columns) column.setZero();
    for (int end = 0; end < 2; ++end) {
      const BoundNode& node = vessels.nodes[static_cast<std::size_t>(end == 0 ? beam.a : beam.b)];
      const BoundState& bound = end == 0 ? first : second;
      add_bound_force(node, model_.tetrahedra, bound, gradient.segment<6>(6 * end), force);
      for (std::size_t i = 0; i < 4; ++i)
        columns[static_cast<std::size_t>(coupling.place[static_cast<std::size_t>(4 * end) + i])] +=
            (root * node.weights[static_cast<Eigen::Index>(i)]) * rows.block<6, 3>(0, 6 * end) +
            root * (rows.block<6, 3>(0, 6 * end + 3) * bound.turn[i]);
    }
    std::size_t slot = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(coupling.count); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        Eigen::Map<Eigen::Matrix3d> target(values_.data() +
                                           9 * static_cast<std::ptrdiff_t>(coupling.blocks[slot++]));
        target.noalias() += columns[i].transpose().lazyProduct(columns[j]);
      }
  }
}

void BlockSystem::multiply(const std::vector<double>& values, const Eigen::VectorXd& x,
                           Eigen::VectorXd& y) const {
  y.setZero(x.size());
  for (int c = 0; c < pattern_.unknowns; ++c) {
    const Eigen::Vector3d xc = x.segment<3>(3 * c);
    Eigen::Vector3d yc = Eigen::Vector3d::Zero();
    const int first = pattern_.column_start[static_cast<std::size_t>(c)];
    const int last = pattern_.column_start[static_cast<std::size_t>(c) + 1];
    for (int k = first; k < last; ++k) {
      const Eigen::Map<const Eigen::Matrix3d> block(values.data() + static_cast<std::ptrdiff_t>(k) * 9);
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

Points BlockSystem::scatter(const Eigen::VectorXd& x) const {
  Points per_node = Points::Zero(static_cast<Eigen::Index>(pattern_.unknown_of_node.size()), 3);
  for (int u = 0; u < pattern_.unknowns; ++u)
    per_node.row(pattern_.node_of_unknown[static_cast<std::size_t>(u)]) = x.segment<3>(3 * u).transpose();
  return per_node;
}

}  // namespace glisson::fem
