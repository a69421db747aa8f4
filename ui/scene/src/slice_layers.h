// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/ui/scene/slice_picture.h"

/// @file
/// The layers of a slice's picture: grey, and labels over it. Three bytes a pixel, blue first; labels one
/// value a pixel; rows from the top.

namespace glisson::scene {

/// Pixels from `left` to before `right`, `top` to before `bottom`.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool empty() const { return left >= right || top >= bottom; }
  long count() const { return empty() ? 0 : static_cast<long>(right - left) * (bottom - top); }
  /// The smallest box around both.
  PixelBox joined(const PixelBox& other) const;
  /// Grown by so many pixels on each side, within the slice.
  PixelBox grown(int pixels, const SliceGeometry& slice) const;
  static PixelBox all(const SliceGeometry& slice) { return {0, 0, slice.width, slice.height}; }
};

/// @param bytes of the whole slice.
void draw_grey(const Image& image, const SliceGeometry& slice, const SliceStyle& style,
               std::vector<std::uint8_t>& bytes);
/// The closest voxel's label of each pixel in the box. @param found of the whole slice; the rest is left.
void sample_labels(const LabelVolume& labels, const SliceGeometry& slice, const PixelBox& box,
                   std::vector<Label>& found);
/// Lays labels over what `bytes` holds, in the box.
void blend_labels(const std::vector<Label>& labels, const SliceGeometry& slice, const SliceStyle& style,
                  const PixelBox& box, std::vector<std::uint8_t>& bytes);
/// The pixels that show voxels of a brick; empty where the slice does not meet it.
PixelBox pixels_of_brick(const LabelVolume& labels, std::size_t brick, const SliceGeometry& slice);
/// The pixels that show voxels of bricks that the two do not share. @pre one grid.
PixelBox pixels_that_may_differ(const LabelVolume& a, const LabelVolume& b, const SliceGeometry& slice);

}  // namespace glisson::scene
