// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cmath>
#include <opencv2/videoio.hpp>
#include <system_error>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "picture_cv.h"
#include "streams.h"

namespace glisson::stereo {
namespace fs = std::filesystem;

struct VideoWriter::Impl {
  fs::path path, temporary;
  int width = 0, height = 0, written = 0;
  cv::VideoWriter writer;
  bool open = false;

  ~Impl() {
    if (!open) return;
    writer.release();
    std::error_code ignored;
    fs::remove(temporary, ignored);
  }

  void verify() const {
    FileStream stream(temporary);
    const int frames = stream.count_frames();
    if (frames != written || stream.width != width || stream.height != height)
      throw FileError(path.string() + ": " + std::to_string(frames) + " of " + std::to_string(written) +
                      " frames can be read back. Free some space on the disk and record again.");
  }
};

VideoWriter::VideoWriter(const fs::path& path, int width, int height, double frames_per_second)
    : impl_(std::make_unique<Impl>()) {
  require(width > 0 && height > 0 && width % 2 == 0 && height % 2 == 0,
          "the width and height of a video are even");
  require(std::isfinite(frames_per_second) && frames_per_second > 0.0, "a video has a frame rate");
  if (path.extension() != ".mkv")
    throw InputError(path.string(), "", "is not a name for a recording",
                     "Use .mkv: a recording that is cut off can still be read there");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code failure;
  if (!fs::is_directory(folder, failure))
    throw FileError(path.string() + ": its folder does not exist. Create it or choose another.");
  impl_->path = path;
  impl_->temporary = folder / ("." + path.stem().string() + ".writing" + std::to_string(::getpid()) + ".mkv");
  impl_->width = width;
  impl_->height = height;
  try {
    impl_->open = impl_->writer.open(impl_->temporary.string(), cv::CAP_FFMPEG,
                                     cv::VideoWriter::fourcc('m', 'p', '4', 'v'), frames_per_second,
                                     cv::Size(width, height), true);
  } catch (const cv::Exception&) {
    impl_->open = false;
  }
  if (!impl_->open)
    throw FileError(path.string() + ": cannot be opened for recording. Check permissions and space.");
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::write(const Picture& picture) {
  require(impl_->open, "a video that was closed takes no more pictures");
  require(picture.width == impl_->width && picture.height == impl_->height && picture.channels == 3,
          "a picture has the size of its video and three channels");
  impl_->writer.write(view(picture));
  ++impl_->written;
}

void VideoWriter::close() {
  require(impl_->open, "a video is closed once");
  impl_->writer.release();
  flush_to_disk(impl_->temporary);
  impl_->verify();
  std::error_code failure;
  fs::rename(impl_->temporary, impl_->path, failure);
  if (failure) throw FileError(impl_->path.string() + ": could not be replaced (" + failure.message() + ").");
  impl_->open = false;
  flush_to_disk(impl_->path.has_parent_path() ? impl_->path.parent_path() : fs::path("."));
}

}  // namespace glisson::stereo
