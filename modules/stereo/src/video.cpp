// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cmath>
#include <opencv2/videoio.hpp>
#include <system_error>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "picture_cv.h"

namespace glisson::stereo {
namespace fs = std::filesystem;
namespace {

/// One video file with what its container says of it.
struct Source {
  fs::path path;
  cv::VideoCapture capture;
  int width = 0, height = 0, frames = 0;
  double rate = 0.0;

  explicit Source(const fs::path& file) : path(file) { open(); }

  void open() {
    std::error_code failure;
    if (!fs::is_regular_file(path, failure))
      throw FileError(path.string() + ": cannot be opened (no such file). Check the path.");
    bool opened = false;
    try {
      opened = capture.open(path.string(), cv::CAP_FFMPEG);
    } catch (const cv::Exception&) {
      opened = false;
    }
    if (!opened)
      throw InputError(path.string(), "", "is not a video that can be read",
                       "Use a video in .mkv, .mp4 or .avi, and copy it again if it was cut off");
    width = static_cast<int>(capture.get(cv::CAP_PROP_FRAME_WIDTH));
    height = static_cast<int>(capture.get(cv::CAP_PROP_FRAME_HEIGHT));
    rate = capture.get(cv::CAP_PROP_FPS);
    const double count = capture.get(cv::CAP_PROP_FRAME_COUNT);
    // Containers that were never closed do not know their length; it comes as nonsense then.
    frames = count > 0.0 && count < 1e8 ? static_cast<int>(std::lround(count)) : 0;
    if (width <= 0 || height <= 0 || !(rate > 0.0) || rate > 1000.0)
      throw InputError(path.string(), "", "does not say its size or frame rate", "Convert it to .mkv");
  }

  bool read(cv::Mat& image) {
    try {
      return capture.read(image) && !image.empty();
    } catch (const cv::Exception&) {
      return false;
    }
  }
};

/// One frame less than a length that was computed from a rounded duration is still a whole video.
constexpr int kRoundedFrames = 1;

}  // namespace

struct StereoVideo::Impl {
  Source left;
  std::unique_ptr<Source> right;  ///< none: side by side
  int next = 0;

  Impl(const fs::path& l, const fs::path& r) : left(l) {
    if (!r.empty()) right = std::make_unique<Source>(r);
    check();
  }

  void check() const {
    if (!right) {
      if (left.width % 2 != 0)
        throw InputError(left.path.string(), "",
                         "is " + std::to_string(left.width) + " pixels wide, so it has no two halves",
                         "A side-by-side video has an even width; give two files otherwise");
      return;
    }
    if (left.width != right->width || left.height != right->height)
      throw InputError(right->path.string(), "",
                       "is " + std::to_string(right->width) + "x" + std::to_string(right->height) +
                           ", the left video " + std::to_string(left.width) + "x" +
                           std::to_string(left.height),
                       "Both views of a stereo video have one size");
    if (std::abs(left.rate - right->rate) > 1e-3 * left.rate)
      throw InputError(right->path.string(), "", "has another frame rate than the left video",
                       "Record both views at one rate");
  }

  [[noreturn]] void broken_off(const Source& source) const {
    throw InputError(source.path.string(), "",
                     "breaks off after " + std::to_string(next) + " frames of " +
                         std::to_string(std::max(left.frames, right ? right->frames : 0)),
                     "Copy the video again, or record it anew");
  }
};

StereoVideo::StereoVideo(const fs::path& left, const fs::path& right)
    : impl_(std::make_unique<Impl>(left, right)) {}
StereoVideo::~StereoVideo() = default;

int StereoVideo::width() const { return impl_->right ? impl_->left.width : impl_->left.width / 2; }
int StereoVideo::height() const { return impl_->left.height; }
double StereoVideo::frames_per_second() const { return impl_->left.rate; }
int StereoVideo::frame_count() const { return impl_->left.frames; }

bool StereoVideo::read(StereoFrame& frame) {
  cv::Mat left, right;
  const bool has_left = impl_->left.read(left);
  const bool has_right = impl_->right ? impl_->right->read(right) : has_left;
  if (!has_left || !has_right) {
    if (has_left != has_right) impl_->broken_off(has_left ? *impl_->right : impl_->left);
    if (impl_->next + kRoundedFrames < impl_->left.frames) impl_->broken_off(impl_->left);
    if (impl_->right && impl_->next + kRoundedFrames < impl_->right->frames) impl_->broken_off(*impl_->right);
    return false;
  }
  if (!impl_->right) {
    right = left.colRange(left.cols / 2, left.cols);
    left = left.colRange(0, left.cols / 2);
  }
  frame.left = to_picture(left);
  frame.right = to_picture(right);
  frame.index = impl_->next++;
  frame.seconds = frame.index / impl_->left.rate;
  return true;
}

void StereoVideo::rewind() {
  impl_->left.open();
  if (impl_->right) impl_->right->open();
  impl_->next = 0;
}

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
    Source source(temporary);
    int frames = 0;
    while (source.capture.grab()) ++frames;
    if (frames != written || source.width != width || source.height != height)
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
