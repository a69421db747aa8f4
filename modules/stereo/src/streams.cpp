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

struct DeviceStream::Camera {
  std::unique_ptr<cv::VideoCapture> capture;
  bool has_grabbed = false;
  double seconds = 0.0;

  void grab() {
    try {
      has_grabbed = capture->grab();
    } catch (const cv::Exception&) {
      has_grabbed = false;
    }
    // One clock for all devices: times since each was opened would never meet.
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
};

DeviceStream::DeviceStream(const std::string& device, const RunContext& context)
    : camera_(std::make_shared<Camera>()), context_(context.quiet()) {
  name = device_source(device);
  require_known_scheme(name);
  live = true;
  const auto open = [camera = camera_, device] { camera->capture = codecs().camera(device); };
  if (!aside_.run(open, context_)) return;
  const auto& capture = camera_->capture;
  if (!capture)
    throw InputError(name, "", "cannot be opened",
                     "Check that the camera is connected, that no other program uses it, and its number");
  width = static_cast<int>(capture->get(cv::CAP_PROP_FRAME_WIDTH));
  height = static_cast<int>(capture->get(cv::CAP_PROP_FRAME_HEIGHT));
  rate = capture->get(cv::CAP_PROP_FPS);
  if (!(rate > 0.0) || rate > 1000.0) rate = 30.0;
}

bool DeviceStream::grab() {
  if (!aside_.run([camera = camera_] { camera->grab(); }, context_) || !camera_->has_grabbed) return false;
  seconds = camera_->seconds;
  return true;
}

bool DeviceStream::retrieve(cv::Mat& image) {
  try {
    return camera_->capture->retrieve(image) && !image.empty();
  } catch (const cv::Exception&) {
    return false;
  }
}

}  // namespace glisson::stereo
