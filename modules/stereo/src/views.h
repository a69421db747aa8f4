// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "glisson/core/error.h"

namespace glisson::stereo {

/// What gives both views of a moment.
class Views {
 public:
  virtual ~Views() = default;
  /// Both hold until the next is read. @return false at the end.
  virtual bool read(cv::Mat& left, cv::Mat& right) = 0;
  virtual void rewind() = 0;
  /// When what was read last came, of a live source.
  virtual std::optional<double> came() const { return std::nullopt; }
  /// The time of what was read last as its file has it, seconds. Empty: it has none, or is live.
  virtual std::optional<double> stamped() const { return std::nullopt; }

  int width = 0, height = 0, frames = 0, skipped = 0;  ///< of one view
  double rate = 0.0;

 protected:
  [[noreturn]] static void broken_off(const std::string& name, int read, int of) {
    throw InputError(name, "",
                     "breaks off after " + std::to_string(read) + " frames of " + std::to_string(of),
                     "Copy the video again, or record it anew");
  }
};

}  // namespace glisson::stereo
