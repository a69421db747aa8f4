// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/picture_io.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "picture_cv.h"
#include "picture_header.h"

namespace glisson::stereo {
namespace {

constexpr long kMostPixels = 64000000;  // a file of a few kilobytes may claim gigabytes

}  // namespace

cv::Mat view(const Picture& picture) {
  require(picture.channels == 1 || picture.channels == 3, "a picture has one channel or three");
  require(!picture.empty() && picture.bytes->size() == static_cast<std::size_t>(picture.width) *
                                                           static_cast<std::size_t>(picture.height) *
                                                           static_cast<std::size_t>(picture.channels),
          "a picture has as many bytes as its size says");
  // cv::Mat knows no const data; callers only read.
  return cv::Mat(picture.height, picture.width, CV_8UC(picture.channels),
                 const_cast<std::uint8_t*>(picture.bytes->data()));
}

Picture to_picture(const cv::Mat& image) {
  require(image.depth() == CV_8U && (image.channels() == 1 || image.channels() == 3),
          "a picture has 8 bits and one channel or three");
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(image.total() * image.elemSize());
  image.copyTo(cv::Mat(image.rows, image.cols, image.type(), bytes->data()));
  return {image.cols, image.rows, image.channels(), std::move(bytes)};
}

cv::Mat grey(const Picture& picture) {
  const cv::Mat source = view(picture);
  cv::Mat result;
  if (picture.channels == 1)
    source.copyTo(result);
  else
    cv::cvtColor(source, result, cv::COLOR_BGR2GRAY);
  return result;
}

cv::Mat grey_float(const Picture& picture) {
  cv::Mat result;
  view(picture).convertTo(result, CV_32F);
  if (picture.channels == 3) cv::cvtColor(result, result, cv::COLOR_BGR2GRAY);
  return result;
}

Picture read_picture(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  cv::Mat image;
  const auto header = picture_header(content);
  if (header && header->width > kMostPixels / header->height)
    throw InputError(path.string(), "size",
                     "claims " + std::to_string(header->width) + " x " + std::to_string(header->height) +
                         " pixels, more than any camera has",
                     "The file is damaged: copy it again");
  bool whole = header.has_value();
  // libjpeg fills what is missing with grey and reports success; libpng complains on the terminal.
  if (content.starts_with("\x89PNG")) whole = content.rfind("IEND") != std::string::npos;
  if (content.starts_with("\xFF\xD8")) whole = content.rfind("\xFF\xD9") != std::string::npos;
  if (whole) {
    const cv::Mat bytes(1, static_cast<int>(content.size()), CV_8U, const_cast<char*>(content.data()));
    try {
      // As the sensor saw it: a rotation tag would break the calibration.
      image = cv::imdecode(bytes, cv::IMREAD_ANYCOLOR | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) {
      image.release();
    }
  }
  if (image.empty())
    throw InputError(path.string(), "", "is not a whole picture that can be read",
                     "Use PNG, JPEG, BMP or TIFF, and copy it again if it was cut off");
  return to_picture(image);
}

void write_picture(const std::filesystem::path& path, const Picture& picture) {
  const std::string extension = lower_extension(path);
  if (extension != ".png" && extension != ".jpg" && extension != ".jpeg" && extension != ".bmp")
    throw InputError(path.string(), "", "has no extension of a picture", "Use .png, .jpg or .bmp");
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(extension, view(picture), bytes))
    throw FileError(path.string() + ": the picture could not be encoded. Use .png.");
  write_file_atomically(path, std::string(bytes.begin(), bytes.end()));
}

}  // namespace glisson::stereo
