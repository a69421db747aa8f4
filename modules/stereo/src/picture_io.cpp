// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/picture_io.h"

#include <opencv2/imgproc.hpp>

#include "../codecs/opencv_codecs.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/png.h"
#include "picture_cv.h"

namespace glisson::stereo {
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
  const std::size_t row = static_cast<std::size_t>(image.cols) * image.elemSize();
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  bytes->reserve(row * static_cast<std::size_t>(image.rows));
  for (int y = 0; y < image.rows; ++y) bytes->insert(bytes->end(), image.ptr(y), image.ptr(y) + row);
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

namespace {

/// @param name what errors call it.
std::string encoded(const std::string& name, const std::string& extension, const Picture& picture,
                    int quality) {
  const std::vector<std::uint8_t> bytes = codecs().encode(extension, view(picture), quality);
  if (bytes.empty()) throw FileError(name + ": the picture could not be encoded. Free some memory.");
  return {bytes.begin(), bytes.end()};
}

}  // namespace

void write_picture(const std::filesystem::path& path, const Picture& picture) {
  const std::string extension = lower_extension(path);
  if (extension != ".png" && extension != ".jpg" && extension != ".jpeg" && extension != ".bmp")
    throw InputError(path.string(), "", "has no extension of a picture", "Use .png, .jpg or .bmp");
  constexpr int kQuality = 95;
  write_file_atomically(path, encoded(path.string(), extension, picture, kQuality));
}

std::string png_of(const Picture& picture) { return encoded("PNG", ".png", picture, 0); }
std::string jpeg_of(const Picture& picture, int quality) { return encoded("JPEG", ".jpg", picture, quality); }

}  // namespace glisson::stereo
