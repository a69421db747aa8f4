// SPDX-License-Identifier: GPL-3.0-or-later
//
// glisson-read-pictures pictures | video FILE | escapes FOLDER
//
// Decodes foreign pictures and videos for Glisson and hands back their pixels (questions.h), because a
// decoder that a file has broken or taken over must do so alone. It gives up all before the first foreign
// byte: of pictures it gets the bytes, of videos it may read the one file, and it can write nothing at all.
// "escapes" leaves in FOLDER/escapes what it could do that it must not, a word a line.

#include <cstdint>
#include <cstdio>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "../codecs/opencv_codecs.h"
#include "glisson/core/child_side.h"
#include "glisson/core/confinement.h"
#include "glisson/core/error.h"
#include "questions.h"

namespace {

using namespace glisson;
using namespace stereo::reader;
using child_side::allow_seconds;
using child_side::hear;
using child_side::tell;

bool tell_pixels(cv::Mat image) {
  const bool good =
      !image.empty() && image.depth() == CV_8U && (image.channels() == 1 || image.channels() == 3);
  if (!good) return tell(PixelAnswer());
  if (!image.isContinuous()) image = image.clone();
  return tell(PixelAnswer{image.cols, image.rows, image.channels(), 0}) &&
         tell(image.data, image.total() * image.elemSize());
}

int read_pictures() {
  confine({}, {});
  for (PictureQuestion question; hear(question);) {
    const double pixels = static_cast<double>(question.pixels);
    // Progressive JPEG may go over its pixels any number of times.
    allow_seconds(3.0 + 3e-7 * pixels);
    limit_memory(1.5e9 + 4.0 * static_cast<double>(question.bytes) + 24.0 * pixels);
    if (question.bytes > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) return 1;
    std::vector<std::uint8_t> bytes(question.bytes);
    if (!hear(bytes.data(), bytes.size())) return 0;
    cv::Mat image;
    try {
      // As the sensor saw it: a rotation tag would break the calibration.
      image = cv::imdecode(bytes, cv::IMREAD_ANYCOLOR | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) {
      image.release();
    }
    if (!tell_pixels(image)) return 0;
  }
  return 0;
}

constexpr double kFrameSeconds = 20.0;

VideoAnswer header_of(const cv::VideoCapture& capture) {
  try {
    return {kOpened,
            static_cast<int>(capture.get(cv::CAP_PROP_FRAME_WIDTH)),
            static_cast<int>(capture.get(cv::CAP_PROP_FRAME_HEIGHT)),
            0,
            capture.get(cv::CAP_PROP_FPS),
            capture.get(cv::CAP_PROP_FRAME_COUNT)};
  } catch (const cv::Exception&) {
    return {};
  }
}

int read_video(const std::string& path) {
  limit_memory(4e9);
  allow_seconds(kFrameSeconds);
  const stereo::Codecs& decoder = stereo::codecs();  // no library can be loaded any more once all is given up
  confine({path}, {});
  const std::unique_ptr<cv::VideoCapture> capture = decoder.video(path);
  if (!tell(capture ? header_of(*capture) : VideoAnswer()) || !capture) return 0;
  for (char question = 0; hear(question);) {
    allow_seconds(kFrameSeconds);
    cv::Mat image;
    GrabAnswer grabbed;
    try {
      if (question == kGrab && capture->grab()) grabbed = {1, 0, capture->get(cv::CAP_PROP_POS_MSEC)};
      if (question == kRetrieve && !capture->retrieve(image)) image.release();
    } catch (const cv::Exception&) {
      image.release();
    }
    if (!(question == kGrab ? tell(grabbed) : tell_pixels(image))) return 0;
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  const std::string_view mode = count > 1 ? words[1] : "";
  child_side::begin();
  if (mode == "pictures" && count == 2) return read_pictures();
  try {
    if (mode == "video" && count == 3) return read_video(words[2]);
  } catch (const FileError&) {
    return tell(VideoAnswer{kNoDecoder}) ? 1 : 0;
  }
  if (mode == "escapes" && count == 3) return child_side::tell_escapes(words[2]);
  std::fprintf(stderr, "glisson-read-pictures MODE ...: a helper of Glisson, not run by hand\n");
  return 2;
}
