// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace glisson {

/// An 8-bit picture, rows from the top, channels interleaved (1: grey; 3: blue, green, red). Immutable and
/// shared.
struct Picture {
  int width = 0, height = 0, channels = 3;
  std::shared_ptr<const std::vector<std::uint8_t>> bytes;

  bool empty() const { return !bytes || bytes->empty(); }
};

/// One moment of the laparoscope.
struct StereoFrame {
  Picture left, right;
  int index = 0;         ///< of the frame in its source, 0-based
  double seconds = 0.0;  ///< since the source's start
};

}  // namespace glisson
