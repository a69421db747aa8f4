// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/editing/tool.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// A brush drawn along a path: a ball, or a disc in the slice of the path. All voxels whose centres lie
/// within the radius of the path, and those that the path runs through, however small the brush. The path may
/// leave the volume. Overwrites; erases.
struct Paint {
  static const ToolKind& kind();
  enum class Brush { disc, ball };
  Label label = structure::kParenchyma;
  /// Takes voxels of `label` away; with kBackground of any label. What a vessel or a lesion loses becomes
  /// what is nearer of parenchyma and background (within 12 mm of the stroke; parenchyma where they are
  /// equally near), so that a branch that is rubbed out leaves no hole in the liver. Otherwise background.
  bool erase = false;
  Brush brush = Brush::disc;
  double radius = 5e-3;
  int normal_axis = 2;     ///< disc: the voxel axis across the slice, 0, 1 or 2
  PointsIn<CtFrame> path;  ///< one point or more, CT frame

  bool operator==(const Paint&) const;  // paths of different lengths differ
};

}  // namespace glisson::editing
