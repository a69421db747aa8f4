// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "glisson/core/statistics.h"
#include "pixel_scale.h"

namespace glisson::guidance {
namespace {

constexpr int kBlock = 4;
constexpr int kHighlight = 245;
constexpr double kLeastNoise = 0.5;  ///< grey levels: what rounding alone leaves

int green(const Picture& picture, int x, int y) {
  const auto at =
      static_cast<std::size_t>(picture.channels) *
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
  return (*picture.bytes)[at + (picture.channels == 3 ? 1 : 0)];
}

struct Block {
  double mean = 0.0;
  /// Immerkaer's: second differences along both axes cancel slopes and edges and leave noise.
  double noise = 0.0;
  bool clear = true;  ///< no highlight
};

/// @param apart pixels from one that is looked at to the next.
Block look_at(const Picture& picture, int left, int top, int apart) {
  Block block;
  for (int y = 0; y < kBlock; ++y)
    for (int x = 0; x < kBlock; ++x) {
      const int grey = green(picture, left + apart * x, top + apart * y);
      block.mean += grey / static_cast<double>(kBlock * kBlock);
      block.clear = block.clear && grey < kHighlight;
    }
  // Of neighbours always: noise is each pixel's own.
  const auto v = [&](int y, int x) { return green(picture, left + x, top + y); };
  const int second = v(0, 0) - 2 * v(0, 1) + v(0, 2) - 2 * (v(1, 0) - 2 * v(1, 1) + v(1, 2)) + v(2, 0) -
                     2 * v(2, 1) + v(2, 2);
  block.noise = std::abs(second) * std::sqrt(std::acos(0.0)) / 6.0;
  return block;
}

}  // namespace

double PictureMeasures::signal() const { return detail / std::max(noise, kLeastNoise); }

double signal_at_start(const Picture& first, double least) {
  return std::max(least, measure(first).signal());
}

PictureMeasures measure(const Picture& picture) {
  // What tissue shows has as many more pixels as the picture has.
  const int apart = static_cast<int>(pixel_scale(picture.width)), side = apart * kBlock;
  const int step = 2 * side;  // every second block, with its neighbour to the right
  std::vector<double> means;
  double squares = 0.0, noise = 0.0;
  for (int y = 0; y + side <= picture.height; y += step)
    for (int x = 0; x + 2 * side <= picture.width; x += step) {
      const Block a = look_at(picture, x, y, apart), b = look_at(picture, x + side, y, apart);
      if (!a.clear || !b.clear) continue;
      means.push_back(a.mean);
      // An outline is one place; what tissue shows is everywhere: large steps count as moderate ones.
      squares += std::min(std::pow(a.mean - b.mean, 2), 400.0);
      noise += 0.5 * (a.noise + b.noise);
    }
  PictureMeasures result;
  if (means.empty()) return result;
  const auto n = static_cast<double>(means.size());
  result.noise = noise / n;
  // Noise makes two means differ, too.
  result.detail = std::sqrt(std::max(0.0, squares / n - 2.0 * std::pow(result.noise / kBlock, 2)));
  result.brightness = upper_median(std::move(means));
  return result;
}

}  // namespace glisson::guidance
