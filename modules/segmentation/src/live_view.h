// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "field.h"
#include "glisson/segmentation/segment.h"

namespace glisson::segmentation {

/// Shows the contour while it moves: phi < 0 on the image's grid, brick by brick, only where a sign changed
/// since the last time. Its own cost stays below a fifth of the work's time.
class LiveView {
 public:
  /// @param grid of the whole image. @param region the part of it that the fields' indices count from.
  LiveView(const VolumeGrid& grid, VoxelBox region, ShowLiver show);
  /// Shows phi, unless nobody looks or it is too early.
  void update(const Field& phi);
  /// Shows phi in any case, if anybody looks.
  void finish(const Field& phi);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(const Field& phi);
  /// Whether a sign changed where `box` of the region is interpolated from.
  bool moved_within(const Field& phi, const VoxelBox& box) const;

  LabelVolume liver_;
  VoxelBox region_;
  ShowLiver show_;
  Clock::time_point next_ = Clock::time_point::min();
  Field shown_;  ///< grid and signs of what was shown last
};

}  // namespace glisson::segmentation
