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

/// What of a left picture is not liver: tools, hands, gauze.
struct PictureMask {
  Picture not_liver;  ///< one channel, of the picture's size, non-zero where it is not
  int index = -1;     ///< of the frame
  double seconds = 0.0;
};

}  // namespace glisson
