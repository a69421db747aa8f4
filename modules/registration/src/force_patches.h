// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/fem/elastic_body.h"
#include "glisson/geometry/topology.h"

namespace glisson::registration {

/// A place where something may press or pull: a hat function over the surface, its weights on the nodes sum
/// to 1, so that a force of 1 N is 1 N.
struct ForcePatch {
  int node = -1;  ///< at its centre
  std::vector<std::pair<int, double>> weights;
};

/// A unit force on each patch, along x, y and z. Shape: 3 nodes x 3 patches.
fem::NodalColumns unit_forces(const std::vector<ForcePatch>& patches, int node_count);

struct PatchGrid {
  double spacing = 12.5e-3;  ///< between neighbouring centres, m
  double radius = 20e-3;     ///< of a patch, m
  double reach = 8e-3;       ///< of centres from what is seen, m
};

/// The free nodes of a body's surface, where forces may act. Immutable.
class ForceSurface {
 public:
  /// @param fixed one a node of the tetrahedral mesh.
  ForceSurface(const BoundarySurface& surface, const Points& rest, const std::vector<char>& fixed);

  /// Patches on a net over the nodes that lie within reach of the seen points (at rest): farthest points
  /// first, from the one next to the middle of what is seen. Does not depend on the numbers of the nodes, but
  /// where distances are equal.
  std::vector<ForcePatch> patches(const Points& seen, const PatchGrid& grid) const;

 private:
  ForcePatch patch(Eigen::Index centre, double radius) const;

  std::vector<int> nodes_;
  Points positions_, normals_;
  Eigen::VectorXd areas_;
};

}  // namespace glisson::registration
