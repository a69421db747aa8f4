// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "beam.h"
#include "tetrahedron.h"

namespace glisson::fem {

/// A vessel node bound to a tetrahedron: position by barycentric weights, frame by its polar rotation.
struct BoundNode {
  int tetrahedron = -1;
  Eigen::Vector4d weights = Eigen::Vector4d::Zero();
  double distance_outside = 0.0;  ///< m; 0 inside
};

struct VesselBeam {
  int a = 0, b = 0;  ///< bound nodes
  BeamElement element;
};

/// All trees' beams, bound to the mesh (eq. 8, assembled globally: a beam's nodes may lie in different
/// tetrahedra).
struct VesselBeams {
  std::vector<BoundNode> nodes;
  std::vector<VesselBeam> beams;
  int nodes_outside = 0;
  int beams_dropped = 0;  ///< both ends outside by more than their radius, or without length
};

VesselBeams bind_vessels(const TetMesh& mesh, const std::vector<VesselTree>& vessels,
                         const CompositeOptions& options);

/// Where a bound node is, and J's rotation rows when asked for: spin = sum over the tetrahedron's nodes of
/// turn[i] dx_i.
struct BoundState {
  BeamNodeState state;
  std::array<Eigen::Matrix3d, 4> turn;
};
BoundState bound_state(const BoundNode& node, const Tetrahedron& element, const Points& x, bool with_turn);
/// Of all nodes, with J's rows.
std::vector<BoundState> bound_states(const VesselBeams& vessels, const std::vector<Tetrahedron>& tetrahedra,
                                     const Points& x);
/// What J's change adds to a bound node's stiffness: the derivative of J^T (0, moment) with the moment held,
/// over the tetrahedron's nodes. @pre the element is neither inverted nor nearly flat.
Eigen::Matrix<double, 12, 12> binding_curvature(const BoundNode& node, const Tetrahedron& element,
                                                const Points& x, const Eigen::Vector3d& moment);
/// Adds minus J^T gradient (force and moment on the bound node) to the nodal forces.
void add_bound_force(const BoundNode& node, const std::vector<Tetrahedron>& tetrahedra,
                     const BoundState& bound, const Eigen::Matrix<double, 6, 1>& gradient, Points& force);

}  // namespace glisson::fem
