// SPDX-License-Identifier: GPL-3.0-or-later
#include "vessel_beams.h"

#include <Eigen/Dense>
#include <string>

#include "glisson/core/error.h"
#include "polar.h"

namespace glisson::fem {
namespace {

void check_tree(const VesselTree& tree, std::size_t number) {
  const std::string name = "vessels[" + std::to_string(number) + "]";
  const auto count = static_cast<int>(tree.nodes.rows());
  if (!tree.nodes.allFinite())
    throw InputError(name, "nodes", "hold coordinates that are not finite", "Build the vessel tree anew");
  if (static_cast<int>(tree.radii.size()) != count)
    throw InputError(
        name, "radii",
        "has " + std::to_string(tree.radii.size()) + " values for " + std::to_string(count) + " nodes",
        "Give one outer radius a node");
  for (int i = 0; i < count; ++i)
    if (!(tree.radii[i] > 0.0) || tree.radii[i] > 0.1)
      throw InputError(name, "radius " + std::to_string(i),
                       "is " + std::to_string(tree.radii[i] * 1e3) + " mm, out of range",
                       "Give outer radii between 0 and 100 mm, in metres");
  for (std::size_t k = 0; k < tree.beams.size(); ++k)
    for (const int i : tree.beams[k])
      if (i < 0 || i >= count)
        throw InputError(name, "beam " + std::to_string(k),
                         "names node " + std::to_string(i) + " of " + std::to_string(count),
                         "Build the vessel tree anew");
}

/// Every node's frame is computed in every step: those that carry no beam are left out.
void drop_unused_nodes(VesselBeams& vessels) {
  std::vector<int> place(vessels.nodes.size(), -1);
  std::vector<BoundNode> used;
  for (VesselBeam& beam : vessels.beams)
    for (int* end : {&beam.a, &beam.b}) {
      int& at = place[static_cast<std::size_t>(*end)];
      if (at < 0) {
        at = static_cast<int>(used.size());
        used.push_back(vessels.nodes[static_cast<std::size_t>(*end)]);
      }
      *end = at;
    }
  vessels.nodes = std::move(used);
}

}  // namespace

VesselBeams bind_vessels(const TetMesh& mesh, const std::vector<VesselTree>& vessels,
                         const CompositeOptions& options) {
  VesselBeams result;
  for (std::size_t v = 0; v < vessels.size(); ++v) {
    const VesselTree& tree = vessels[v];
    check_tree(tree, v);
    if (tree.nodes.rows() == 0) continue;
    const Binding binding = bind_points(mesh, tree.nodes, true);
    const Points bound = binding.apply(mesh, mesh.vertices);
    const auto first = static_cast<int>(result.nodes.size());
    for (Eigen::Index i = 0; i < tree.nodes.rows(); ++i)
      result.nodes.push_back(
          {binding.tetrahedron[static_cast<std::size_t>(i)], binding.weights.row(i).transpose(), 0.0});
    for (const int i : binding.outside)
      result.nodes[static_cast<std::size_t>(first + i)].distance_outside =
          (tree.nodes.row(i) - bound.row(i)).norm();
    result.nodes_outside += static_cast<int>(binding.outside.size());
    for (const auto& [a, b] : tree.beams) {
      const double radius = 0.5 * (tree.radii[a] + tree.radii[b]);
      const double length = (bound.row(b) - bound.row(a)).norm();
      const double outside = std::min(result.nodes[static_cast<std::size_t>(first + a)].distance_outside,
                                      result.nodes[static_cast<std::size_t>(first + b)].distance_outside);
      // A piece that lies wholly outside the liver carries nothing; clamped, it would be a splint on its
      // surface. The mesh is coarser than the vessels: up to a radius outside still counts as inside.
      if (length < 1e-6 || outside > radius) {
        ++result.beams_dropped;
        continue;
      }
      const BeamSection section =
          BeamSection::hollow(radius, options.wall_fraction * radius, options.vessel_wall);
      result.beams.push_back(
          {first + a, first + b, BeamElement(bound.row(a).transpose(), bound.row(b).transpose(), section)});
    }
  }
  drop_unused_nodes(result);
  return result;
}

BoundVessels bound_vessels(const TetMesh& mesh, const std::vector<VesselTree>& vessels) {
  const VesselBeams bound = bind_vessels(mesh, vessels, {});
  return {static_cast<int>(bound.beams.size()), bound.beams_dropped, bound.nodes_outside};
}

BoundState bound_state(const BoundNode& node, const Tetrahedron& element, const Points& x, bool with_turn) {
  BoundState bound;
  for (int i = 0; i < 4; ++i)
    bound.state.position += node.weights[i] * x.row(element.nodes[static_cast<std::size_t>(i)]).transpose();
  const Polar polar = polar_decomposition(element.deformation_gradient(x));
  bound.state.rotation = polar.rotation;
  if (!with_turn) return bound;
  const Eigen::Matrix3d rate = rotation_rate(polar);
  const Eigen::Matrix<double, 3, 4> g = polar.rotation * element.gradients;
  for (int i = 0; i < 4; ++i) {
    Eigen::Matrix3d lever;
    lever << 0.0, -g(2, i), g(1, i), g(2, i), 0.0, -g(0, i), -g(1, i), g(0, i), 0.0;
    bound.turn[static_cast<std::size_t>(i)] = rate * lever;
  }
  return bound;
}

Eigen::Matrix<double, 12, 12> binding_curvature(const BoundNode& node, const Tetrahedron& element,
                                                const Points& x, const Eigen::Vector3d& moment) {
  const BoundState bound = bound_state(node, element, x, true);
  const Eigen::Matrix3d f = element.deformation_gradient(x);
  const Polar polar = polar_decomposition(f);
  const Eigen::Matrix3d rate = rotation_rate(polar);
  const Eigen::Matrix<double, 3, 4> g = polar.rotation * element.gradients;
  const auto cross = [](const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
  };
  Eigen::Matrix<double, 12, 12> curvature;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k) {
      // Node i moves along axis k: the frame spins, the stretch changes, and with them J's rows.
      const Eigen::Matrix3d spin = cross(bound.turn[static_cast<std::size_t>(i)].col(k));
      Eigen::Matrix3d df = -spin * f;
      df.row(k) += element.gradients.col(i).transpose();
      const Eigen::Matrix3d stretch = df * polar.rotation.transpose();  // Q dS Q^T
      const Eigen::Matrix3d sums = stretch.trace() * Eigen::Matrix3d::Identity() - stretch;
      const Eigen::Matrix3d d_rate = spin * rate - rate * spin - rate * sums * rate;
      for (int j = 0; j < 4; ++j) {
        const Eigen::Matrix3d d_turn = d_rate * cross(g.col(j)) + rate * cross(spin * g.col(j));
        curvature.block<3, 1>(3 * j, 3 * i + k) = d_turn.transpose() * moment;
      }
    }
  return curvature;
}

std::vector<BoundState> bound_states(const VesselBeams& vessels, const std::vector<Tetrahedron>& tetrahedra,
                                     const Points& x) {
  std::vector<BoundState> states;
  states.reserve(vessels.nodes.size());
  for (const BoundNode& node : vessels.nodes)
    states.push_back(bound_state(node, tetrahedra[static_cast<std::size_t>(node.tetrahedron)], x, true));
  return states;
}

void add_bound_force(const BoundNode& node, const std::vector<Tetrahedron>& tetrahedra,
                     const BoundState& bound, const Eigen::Matrix<double, 6, 1>& gradient, Points& force) {
  const auto& nodes = tetrahedra[static_cast<std::size_t>(node.tetrahedron)].nodes;
  for (std::size_t i = 0; i < 4; ++i)
    force.row(nodes[i]) -= (node.weights[static_cast<Eigen::Index>(i)] * gradient.head<3>() +
                            bound.turn[i].transpose() * gradient.tail<3>())
                               .transpose();
}

}  // namespace glisson::fem
