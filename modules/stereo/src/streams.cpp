// SPDX-License-Identifier: GPL-3.0-or-later
#include "streams.h"

#include <chrono>
#include <cmath>
#include <fstream>
#include <system_error>

#include "../codecs/opencv_codecs.h"
#include "foreign_pictures.h"
#include "glisson/core/error.h"
#include "glisson/stereo/reach.h"
#include "glisson/stereo/source.h"

namespace glisson::stereo {
namespace fs = std::filesystem;

FileStream::FileStream(const fs::path& path) : path_(path) {
  name = path.string();
  open();
}
FileStream::~FileStream() = default;

void FileStream::open() {
  std::error_code failure;
  if (!fs::is_regular_file(path_, failure))
    throw FileError(name + ": cannot be opened (no such file). Check the path.");
  std::string begin(16, '\0');
  std::ifstream file(path_, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  // A play list by the name of a video would be followed wherever it leads.
  if (begins_as_video(begin)) video_ = std::make_unique<ForeignVideo>(path_);
  if (!video_ || !video_->header())
    throw InputError(name, "", "is not a video that can be read",
                     "Use a video in .mkv, .mp4 or .avi, and copy it again if it was cut off");
  width = video_->header()->width;
  height = video_->header()->height;
  rate = video_->header()->rate;
  const double count = video_->header()->frames;
  // Containers that were never closed do not know their length; it comes as nonsense then.
  frames = count > 0.0 && count < 1e8 ? static_cast<int>(std::lround(count)) : 0;
  taken_ = 0;
  if (width <= 0 || height <= 0 || width > kMostPixels / height || !(rate > 0.0) || rate > 1000.0)
    throw InputError(name, "", "does not say its size or frame rate", "Convert it to .mkv");
}

void FileStream::rewind() { open(); }

bool FileStream::grab() {
  const auto grabbed = video_->grab();
  if (!grabbed)
    throw InputError(
        name, "",
        "is damaged after " + std::to_string(taken_) + " frames: the program that reads it broke down",
        "Copy the video again, or record it anew");
  if (grabbed->grabbed != 1) return false;
  const double stamp = 1e-3 * grabbed->milliseconds;
  // Times are since the first picture, for which OpenCV tells when it was decoded. Some containers have none,
  // and a reader that was taken over may tell any: counted then.
  seconds = std::isfinite(stamp) && stamp > 0.0 && taken_ > 0 ? stamp : taken_ / rate;
  ++taken_;
  return true;
}

bool FileStream::retrieve(cv::Mat& image) { return video_->retrieve(image); }

int FileStream::count_frames() {
  constexpr int kMost = 20'000'000;  // four days: more is no operation
  int count = 0;
  while (count < kMost && grab()) ++count;
  return count;
}

DeviceStream::DeviceStream(const std::string& device) {
  name = device_source(device);
  require_known_scheme(name);
  live = true;
  capture_ = codecs().camera(device);
  if (!capture_)
    throw InputError(name, "", "cannot be opened",
                     "Check that the camera is connected, that no other program uses it, and its number");
  width = static_cast<int>(capture_->get(cv::CAP_PROP_FRAME_WIDTH));
  height = static_cast<int>(capture_->get(cv::CAP_PROP_FRAME_HEIGHT));
  rate = capture_->get(cv::CAP_PROP_FPS);
  if (!(rate > 0.0) || rate > 1000.0) rate = 30.0;
}

bool DeviceStream::grab() {
  try {
    if (!capture_->grab()) return false;
  } catch (const cv::Exception&) {
    return false;
  }
  // One clock for all devices: times since each was opened would never meet.
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  return true;
}

bool DeviceStream::retrieve(cv::Mat& image) {
  try {
    return capture_->retrieve(image) && !image.empty();
  } catch (const cv::Exception&) {
    return false;
  }
}

}  // namespace glisson::stereo
