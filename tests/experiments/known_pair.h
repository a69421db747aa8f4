// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The middle quarter of a picture: there tissue fills it.
template <class T>
std::vector<T> middle_of(const std::vector<T>& values, int width, int height, int channels) {
  std::vector<T> middle;
  for (int y = height / 4; y < 3 * height / 4; ++y) {
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(y) * width * channels;
    middle.insert(middle.end(), row + static_cast<std::ptrdiff_t>(width / 4) * channels,
                  row + static_cast<std::ptrdiff_t>(3 * width / 4) * channels);
  }
  return middle;
}
inline Picture middle_of(const Picture& picture) {
  return {picture.width / 2, picture.height / 2, picture.channels,
          std::make_shared<std::vector<std::uint8_t>>(
              middle_of(*picture.bytes, picture.width, picture.height, picture.channels))};
}

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
  known.depth = middle_of((*theatre)->depth(0), options.width, options.height, 1);
  auto liver = std::make_shared<std::vector<std::uint8_t>>();
  for (const float z : known.depth) liver->push_back(z > 0.0F ? 255 : 0);
  StereoRig rig = (*theatre)->rig();
  for (Camera* camera : {&rig.left, &rig.right}) {
    camera->matrix(0, 2) -= options.width / 4.0;
    camera->matrix(1, 2) -= options.height / 4.0;
    camera->width /= 2;
    camera->height /= 2;
  }
  known.pair = {middle_of(frame.left),
                middle_of(frame.right),
                {rig.left.width, rig.left.height, 1, std::move(liver)},
                rig};
  return known;
}

}  // namespace glisson::experiments::test
