// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiles.h"

#include <algorithm>
#include <cmath>

namespace glisson::network {

std::vector<int> tile_starts(int size, int tile, double overlap) {
  if (size <= tile) return {0};
  const int step = std::max(1, static_cast<int>(tile * (1.0 - overlap)));
  const int last = size - tile, gaps = (last + step - 1) / step;
  std::vector<int> starts;
  for (int n = 0; n <= gaps; ++n) starts.push_back(static_cast<int>(static_cast<long>(n) * last / gaps));
  return starts;
}

float tile_weight(int voxel, int tile) { return static_cast<float>(std::min(voxel + 1, tile - voxel)); }

TileBlend::TileBlend(const Three& size, const Three& tile, const std::array<std::vector<int>, 3>& starts,
                     int channels)
    : size_(size), tile_(tile), channels_(channels) {
  for (std::size_t n = 0; n < 3; ++n) {
    total_[n].assign(static_cast<std::size_t>(size[n]), 0.0F);
    for (const int start : starts[n])
      for (int voxel = 0; voxel < std::min(tile[n], size[n] - start); ++voxel)
        total_[n][static_cast<std::size_t>(start + voxel)] += tile_weight(voxel, tile[n]);
  }
  const auto values = static_cast<std::size_t>(channels) * static_cast<std::size_t>(size[1]) *
                      static_cast<std::size_t>(size[2]);
  held_.assign(static_cast<std::size_t>(std::min(tile[0], size[0])), std::vector<float>(values, 0.0F));
}

void TileBlend::add(const Three& start, const std::vector<float>& scores) {
  const auto tile_at = [&](int channel, int slice, int row) {
    return static_cast<std::size_t>((static_cast<long>(channel) * tile_[0] + slice) * tile_[1] + row) *
           static_cast<std::size_t>(tile_[2]);
  };
  const auto volume_at = [&](int channel, int row) {
    return static_cast<std::size_t>(static_cast<long>(channel) * size_[1] + row) *
               static_cast<std::size_t>(size_[2]) +
           static_cast<std::size_t>(start[2]);
  };
  const int columns = std::min(tile_[2], size_[2] - start[2]);
  for (int slice = 0; slice < std::min(tile_[0], size_[0] - start[0]); ++slice)
    for (int channel = 0; channel < channels_; ++channel)
      for (int row = 0; row < std::min(tile_[1], size_[1] - start[1]); ++row) {
        const float weight = tile_weight(slice, tile_[0]) * tile_weight(row, tile_[1]);
        const float* from = scores.data() + tile_at(channel, slice, row);
        float* to = slab(start[0] + slice).data() + volume_at(channel, start[1] + row);
        for (int column = 0; column < columns; ++column)
          to[column] += weight * tile_weight(column, tile_[2]) * from[column];
      }
}

std::vector<float> TileBlend::take(int slice) {
  std::vector<float> scores(slab(slice).size(), 0.0F);
  scores.swap(slab(slice));
  const float along = total_[0][static_cast<std::size_t>(slice)];
  float* value = scores.data();
  for (int channel = 0; channel < channels_; ++channel)
    for (const float down : total_[1])
      for (const float across : total_[2]) *value++ /= along * down * across;
  return scores;
}

}  // namespace glisson::network
