// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/core/frames.h"
#include "glisson/geometry/mesh.h"
#include "glisson/volume/image.h"

namespace glisson::editing {

/// What a click of LevelTracing would take, wherever the editable region lets it.
struct TracedLevel {
  /// The closed line around it along the voxels' faces: corners in order, CT frame, metres.
  PointsIn<CtFrame> outline;
  long voxels = 0;
  bool open = false;  ///< it runs out of the slice
};

/// Traces place after place, as the pointer moves: the slice is smoothed once. Not thread-safe.
class LevelTracer {
 public:
  LevelTracer();
  ~LevelTracer();

  /// @param normal_axis voxel axis across the slice: 0, 1 or 2.
  /// @throws InputError the place lies outside the volume.
  TracedLevel trace(const Image& image, int normal_axis, const Point<CtFrame>& p);

 private:
  struct Seen;
  std::unique_ptr<Seen> seen_;
};

}  // namespace glisson::editing
