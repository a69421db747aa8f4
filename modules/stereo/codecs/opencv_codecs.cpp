// SPDX-License-Identifier: GPL-3.0-or-later
#include "opencv_codecs.h"

#include <opencv2/imgcodecs.hpp>

namespace {

using glisson::stereo::Codecs;

class OpenCvCodecs final : public Codecs {
 public:
  std::vector<std::uint8_t> encode(const std::string& extension, const cv::Mat& image,
                                   int quality) const override {
    std::vector<std::uint8_t> bytes;
    if (!cv::imencode(extension, image, bytes, {cv::IMWRITE_JPEG_QUALITY, quality})) bytes.clear();
    return bytes;
  }

  std::unique_ptr<cv::VideoWriter> film(const std::string& path, const std::array<char, 4>& codec,
                                        double frames_per_second, const cv::Size& size) const override {
    auto writer = std::make_unique<cv::VideoWriter>();
    const auto& [a, b, c, d] = codec;
    try {
      if (writer->open(path, cv::CAP_FFMPEG, cv::VideoWriter::fourcc(a, b, c, d), frames_per_second, size))
        return writer;
    } catch (const cv::Exception&) {  // as good as not opened
    }
    return nullptr;
  }

  std::unique_ptr<cv::VideoCapture> video(const std::string& path) const override {
    auto capture = std::make_unique<cv::VideoCapture>();
    try {
      if (capture->open(path, cv::CAP_FFMPEG)) return capture;
    } catch (const cv::Exception&) {  // as good as not opened
    }
    return nullptr;
  }

  std::unique_ptr<cv::VideoCapture> camera(const std::string& device) const override {
    auto capture = std::make_unique<cv::VideoCapture>();
    const bool is_number = device.size() <= 3 && device.find_first_not_of("0123456789") == std::string::npos;
    try {
      if (!(is_number ? capture->open(std::stoi(device), cv::CAP_ANY) : capture->open(device, cv::CAP_ANY)))
        return nullptr;
      // A long queue in the driver would hand out old frames.
      capture->set(cv::CAP_PROP_BUFFERSIZE, 1);
      return capture;
    } catch (const cv::Exception&) {  // as good as not opened
    }
    return nullptr;
  }
};

const OpenCvCodecs kCodecs;

}  // namespace

extern "C" const Codecs* const glisson_codecs;
extern "C" const Codecs* const glisson_codecs = &kCodecs;
