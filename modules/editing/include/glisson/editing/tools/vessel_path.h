// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/editing/tool.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// A vessel along the cheapest way through the image from point to point, as wide as the image shows it: what
/// mends a gap in a tree with two clicks. A way costs little where the image is as bright as at the points
/// and tubular, whether the vessel is brighter or darker than what is about it; it keeps to soft tissue and
/// to voxels that may change. The radius is where the image falls to half across the way, and where that
/// cannot be read that of the nearest places where it can; at least a voxel, so that the tube is connected.
/// Reshapes: takes background and, but for the parenchyma, parenchyma.
/// Notes: "vessel_path.radius_unseen" where no place showed a radius, "vessel_path.faint" (percent of the
/// length) where it had to be taken from elsewhere over more than half of the way.
struct VesselPath {
  static const ToolKind& kind();
  Label label = structure::kPortalVein;
  /// Two or more, in the order of the way; consecutive ones at most 100 mm apart.
  PointsIn<CtFrame> path;
  double largest_radius = 8e-3;  ///< 0.5 to 8 mm

  bool operator==(const VesselPath&) const;  // paths of different lengths differ
};

}  // namespace glisson::editing
