// SPDX-License-Identifier: GPL-3.0-or-later
#include "streams.h"

#include <chrono>
#include <cmath>
#include <fstream>
#include <system_error>

#include "glisson/core/error.h"
#include "glisson/stereo/reach.h"
#include "glisson/stereo/source.h"

namespace glisson::stereo {
namespace fs = std::filesystem;

FileStream::FileStream(const fs::path& path) : path_(path) {
  name = path.string();
  open();
}

void FileStream::open() {
  std::error_code failure;
  if (!fs::is_regular_file(path_, failure))
    throw FileError(name + ": cannot be opened (no such file). Check the path.");
  std::string begin(16, '\0');
  std::ifstream file(path_, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  bool opened = false;
  try {
    // A play list by the name of a video would be followed wherever it leads.
    opened = begins_as_video(begin) && capture_.open(name, cv::CAP_FFMPEG);
  } catch (const cv::Exception&) {
    opened = false;
  }
  if (!opened)
    throw InputError(name, "", "is not a video that can be read",
                     "Use a video in .mkv, .mp4 or .avi, and copy it again if it was cut off");
  width = static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_WIDTH));
  height = static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_HEIGHT));
  rate = capture_.get(cv::CAP_PROP_FPS);
  const double count = capture_.get(cv::CAP_PROP_FRAME_COUNT);
  // Containers that were never closed do not know their length; it comes as nonsense then.
  frames = count > 0.0 && count < 1e8 ? static_cast<int>(std::lround(count)) : 0;
  taken_ = 0;
  if (width <= 0 || height <= 0 || !(rate > 0.0) || rate > 1000.0)
    throw InputError(name, "", "does not say its size or frame rate", "Convert it to .mkv");
}

void FileStream::rewind() { open(); }

bool FileStream::grab() {
  try {
    if (!capture_.grab()) return false;
    const double stamp = 1e-3 * capture_.get(cv::CAP_PROP_POS_MSEC);
    // Some containers have no times: counted then.
    seconds = stamp > 0.0 || taken_ == 0 ? stamp : taken_ / rate;
    ++taken_;
    return true;
  } catch (const cv::Exception&) {
    return false;
  }
}

bool FileStream::retrieve(cv::Mat& image) {
  try {
    return capture_.retrieve(image) && !image.empty();
  } catch (const cv::Exception&) {
    return false;
  }
}

int FileStream::count_frames() {
  int count = 0;
  while (grab()) ++count;
  return count;
}

DeviceStream::DeviceStream(const std::string& device) {
  name = device_source(device);
  require_known_scheme(name);
  live = true;
  const bool is_number = device.size() <= 3 && device.find_first_not_of("0123456789") == std::string::npos;
  bool opened = false;
  try {
    opened = is_number ? capture_.open(std::stoi(device), cv::CAP_ANY) : capture_.open(device, cv::CAP_ANY);
    // A long queue in the driver would hand out old frames.
    if (opened) capture_.set(cv::CAP_PROP_BUFFERSIZE, 1);
  } catch (const cv::Exception&) {
    opened = false;
  }
  if (!opened)
    throw InputError(name, "", "cannot be opened",
                     "Check that the camera is connected, that no other program uses it, and its number");
  width = static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_WIDTH));
  height = static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_HEIGHT));
  rate = capture_.get(cv::CAP_PROP_FPS);
  if (!(rate > 0.0) || rate > 1000.0) rate = 30.0;
}

bool DeviceStream::grab() {
  try {
    if (!capture_.grab()) return false;
  } catch (const cv::Exception&) {
    return false;
  }
  // One clock for all devices: times since each was opened would never meet.
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  return true;
}

bool DeviceStream::retrieve(cv::Mat& image) {
  try {
    return capture_.retrieve(image) && !image.empty();
  } catch (const cv::Exception&) {
    return false;
  }
}

}  // namespace glisson::stereo
