// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>

#include "../reader/questions.h"
#include "glisson/core/child_process.h"

/// @file
/// Pictures and videos as the reading program decodes them. What it answers is believed only as far as it
/// fits: pixels of the size that was claimed, and nothing else.

namespace glisson::stereo {

/// More than any camera has: a file of a few kilobytes may claim gigabytes.
inline constexpr long kMostPixels = 64000000;

/// The frames of one video file, decoded in a process of its own, one frame ahead.
class ForeignVideo {
 public:
  /// @throws FileError the reading program is missing, or its decoder.
  explicit ForeignVideo(const std::filesystem::path& path);
  /// What it says of itself; empty: it cannot be opened, or broke the reader.
  const std::optional<reader::VideoAnswer>& header() const { return header_; }
  /// @return empty: the reader broke down.
  std::optional<reader::GrabAnswer> grab();
  /// The pixels of the frame that was grabbed. False: damaged, or not of the size that the header says.
  bool retrieve(cv::Mat& image);

 private:
  Conversation reader_;
  std::optional<reader::VideoAnswer> header_;
  bool asked_ = false;
};

}  // namespace glisson::stereo
