// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "oriented.h"

namespace glisson::network {

/// Where tiles begin along an axis: the first at its beginning, the last at its end, evenly spread, at least
/// `overlap` of a tile over each other. One that is longer than the axis begins with it.
std::vector<int> tile_starts(int size, int tile, double overlap);
/// What a tile's voxel counts along an axis: most in the middle, least and yet something at its ends.
float tile_weight(int voxel, int tile);

/// Scores of overlapping tiles, blended by their weights: sum(w s) / sum(w). Tiles come slab by slab; only
/// the slices that a later tile may still reach are held.
class TileBlend {
 public:
  /// @param starts of the tiles along the three axes.
  TileBlend(const Three& size, const Three& tile, const std::array<std::vector<int>, 3>& starts,
            int channels);

  /// @param scores channel by channel of a whole tile; what lies beyond the volume is left aside.
  void add(const Three& start, const std::vector<float>& scores);
  /// The slice's blended scores, channel by channel; it is forgotten with it.
  /// @pre every tile that reaches it has been added
  std::vector<float> take(int slice);

 private:
  std::vector<float>& slab(int slice) { return held_[static_cast<std::size_t>(slice) % held_.size()]; }

  Three size_, tile_;
  int channels_;
  std::array<std::vector<float>, 3> total_;  ///< of the weights at each voxel along an axis
  std::vector<std::vector<float>> held_;     ///< as many slices as a tile has
};

}  // namespace glisson::network
