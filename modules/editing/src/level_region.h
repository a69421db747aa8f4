// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/volume/image.h"
#include "glisson/volume/morphology.h"

namespace glisson::editing {

/// One slice of the image, smoothed by a binomial of five so that noise does not tear the iso-line.
struct SmoothedSlice {
  Eigen::Vector2i size;
  std::vector<float> values;

  float at(int u, int v) const {
    return values[static_cast<std::size_t>(u) +
                  static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(v)];
  }
};
/// @param axis across the slice; its u and v run along the other two, the lower one first.
SmoothedSlice smoothed_slice(const Image& image, int axis, int number);

/// A region of the slice without holes.
struct LevelRegion {
  Mask mask;
  long size = 0;
  bool open = false;  ///< it reaches the slice's edge
};
/// What level tracing takes at a place of the slice, in its pixels (see LevelTracing).
LevelRegion traced(const SmoothedSlice& slice, const Eigen::Vector2d& place);

}  // namespace glisson::editing
