// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

#include "glisson/insilico/theatre.h"
#include "real_pairs.h"
#include "theatre_patient.h"

/// @file
/// A pair of pictures whose depth is known, as a laparoscope shows it.

namespace glisson::experiments::test {

struct KnownPair {
  RealPair pair;
  std::vector<float> depth;  ///< metres along the axis, a value a pixel of the left picture
};

/// A quarter of a picture, in which tissue leaves a little room for its outline.
struct Window {
  int x = 0, y = 0, width = 0, height = 0;

  /// The one nearest to the middle with at least the share kTissue of it.
  /// @param depth one value a pixel, 0: no tissue. @param width, height of the picture.
  static Window of_tissue(const std::vector<float>& depth, int width, int height) {
    constexpr int kSteps = 12;
    constexpr double kTissue = 0.9;
    Window best;
    int nearest = 4 * kSteps;
    for (int j = 0; j <= kSteps; ++j)
      for (int i = 0; i <= kSteps; ++i) {
        const Window window{i * width / (2 * kSteps), j * height / (2 * kSteps), width / 2, height / 2};
        const std::vector<float> inside = window.part(depth, width, 1);
        const auto tissue = std::count_if(inside.begin(), inside.end(), [](float z) { return z > 0.0F; });
        const int away = std::abs(2 * i - kSteps) + std::abs(2 * j - kSteps);
        if (away < nearest && static_cast<double>(tissue) >= kTissue * static_cast<double>(inside.size()))
          nearest = away, best = window;
      }
    return best;
  }
  template <class T>
  std::vector<T> part(const std::vector<T>& values, int whole_width, int channels) const {
    std::vector<T> inside;
    for (int row = y; row < y + height; ++row) {
      const auto from = values.begin() + (static_cast<std::ptrdiff_t>(row) * whole_width + x) * channels;
      inside.insert(inside.end(), from, from + static_cast<std::ptrdiff_t>(width) * channels);
    }
    return inside;
  }
  Picture part(const Picture& picture) const {
    return {
        width, height, picture.channels,
        std::make_shared<std::vector<std::uint8_t>>(part(*picture.bytes, picture.width, picture.channels))};
  }
};

/// @param seed of the theatre.
inline KnownPair known_pair(std::uint64_t seed = insilico::TheatreOptions().seed) {
  insilico::TheatreOptions options;
  options.width = 960;
  options.height = 540;
  options.frames = 2;
  options.truth_vertices = 700;
  options.camera_distance_mm = 90.0;
  options.seed = seed;
  const auto theatre = insilico::Theatre::build(insilico::test::small_patient(), options, RunContext());
  const StereoFrame frame = (*theatre)->render(0);
  KnownPair known;
  const std::vector<float> depth = (*theatre)->depth(0);
  const Window window = Window::of_tissue(depth, options.width, options.height);
  known.depth = window.part(depth, options.width, 1);
  auto liver = std::make_shared<std::vector<std::uint8_t>>();
  for (const float z : known.depth) liver->push_back(z > 0.0F ? 255 : 0);
  StereoRig rig = (*theatre)->rig();
  for (Camera* camera : {&rig.left, &rig.right}) {
    camera->matrix(0, 2) -= window.x;
    camera->matrix(1, 2) -= window.y;
    camera->width = window.width;
    camera->height = window.height;
  }
  known.pair = {window.part(frame.left),
                window.part(frame.right),
                {rig.left.width, rig.left.height, 1, std::move(liver)},
                rig};
  return known;
}

}  // namespace glisson::experiments::test
