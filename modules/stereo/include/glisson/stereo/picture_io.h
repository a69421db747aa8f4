// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/patient/picture.h"

namespace glisson::stereo {

/// @throws FileError, InputError.
Picture read_picture(const std::filesystem::path& path);
/// PNG, JPEG or BMP by extension; atomic.
void write_picture(const std::filesystem::path& path, const Picture& picture);

/// A stereo video: one file with the views side by side (left half, right half), or two files.
class StereoVideo {
 public:
  /// @param right empty: `left` is side by side.
  explicit StereoVideo(const std::filesystem::path& left, const std::filesystem::path& right = {});
  ~StereoVideo();
  int width() const;  ///< of one view
  int height() const;
  double frames_per_second() const;
  /// As the container says; may be more than can be read; 0: it does not say.
  int frame_count() const;
  /// The next frame. @return false at the end. @throws InputError when the video breaks off before
  /// frame_count().
  bool read(StereoFrame& frame);
  void rewind();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Writes a video (mp4v in .mkv: a killed file keeps nearly all frames). close() flushes, reads back the
/// number of frames and renames; without close() nothing remains.
/// @pre even width and height; pictures of that size, three channels. @throws InputError another extension
/// than .mkv, FileError.
class VideoWriter {
 public:
  VideoWriter(const std::filesystem::path& path, int width, int height, double frames_per_second);
  ~VideoWriter();
  void write(const Picture& picture);
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::stereo
