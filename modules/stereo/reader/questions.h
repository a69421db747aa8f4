// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// @file
/// What glisson-read-pictures is asked and what it answers, as bytes of one machine.

namespace glisson::stereo::reader {

/// Mode "pictures": a file's bytes follow.
struct PictureQuestion {
  std::uint64_t bytes = 0;
  std::uint64_t pixels = 0;  ///< as its header claims: what may be spent on it
};

/// Whether a video could be opened; without a decoder (opencv_codecs.h) none can.
inline constexpr std::int32_t kOpened = 1, kNoDecoder = 2;

/// Mode "video": the reader begins with what it has opened.
struct VideoAnswer {
  std::int32_t opened = 0;  ///< kOpened, kNoDecoder, or anything else: it cannot be
  std::int32_t width = 0, height = 0, reserved = 0;
  double rate = 0.0, frames = 0.0;
};
/// Then it is asked by one letter, for the next frame or for the pixels of that frame.
constexpr char kGrab = 'g', kRetrieve = 'r';
struct GrabAnswer {
  std::int32_t grabbed = 0, reserved = 0;
  double milliseconds = 0.0;
};

/// The pixels follow, row by row, 8 bits, blue first where there are three channels.
struct PixelAnswer {
  std::int32_t width = 0, height = 0, channels = 0;  ///< all 0: it could not be decoded
  std::int32_t reserved = 0;
};

}  // namespace glisson::stereo::reader
