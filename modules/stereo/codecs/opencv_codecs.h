// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

/// @file
/// OpenCV's codecs and cameras, in a library of their own that is loaded when they are first asked for. They
/// bring some 190 other libraries along, GDAL's and FFmpeg's among them, for which every start would wait
/// (four fifths of it), and which nothing but these needs.

namespace glisson::stereo {

class Codecs {
 public:
  virtual ~Codecs() = default;
  /// The bytes of a file. @param extension ".png", ".jpg", ".bmp". @param quality of JPEG, 1 to 100.
  /// @return empty: it cannot be encoded.
  virtual std::vector<std::uint8_t> encode(const std::string& extension, const cv::Mat& image,
                                           int quality) const = 0;
  /// A video to be written. @return null: it cannot be opened.
  virtual std::unique_ptr<cv::VideoWriter> film(const std::string& path, const std::array<char, 4>& codec,
                                                double frames_per_second, const cv::Size& size) const = 0;
  /// The frames of a file, decoded by FFmpeg. For the confined reader only. @return null: as above.
  virtual std::unique_ptr<cv::VideoCapture> video(const std::string& path) const = 0;
  /// @param device a camera's number, or what OpenCV opens by name. @return null: it cannot be opened.
  virtual std::unique_ptr<cv::VideoCapture> camera(const std::string& device) const = 0;
};

/// The variable of type `const Codecs*` by which the library is asked.
inline constexpr const char* kCodecsSymbol = "glisson_codecs";

/// Loaded by the first call (0.2 s), and never let go. Only virtual functions of what it gives may be called:
/// the program itself is not linked with OpenCV's codecs. From any thread.
/// @throws FileError it is missing or cannot be loaded.
const Codecs& codecs();

}  // namespace glisson::stereo
