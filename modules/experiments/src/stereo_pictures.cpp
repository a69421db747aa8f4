// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "cv_picture.h"
#include "stereo_theatre.h"

namespace glisson::experiments {
Picture hardened(const Picture& picture, const Hardship& hardship, std::uint64_t seed) {
  constexpr double kFine = 8.0;
  cv::Mat image = view_of(picture).clone();
  std::mt19937_64 random(seed);
  if (hardship.texture != 1.0) {
    cv::Mat coarse;
    cv::GaussianBlur(image, coarse, cv::Size(), kFine);
    cv::addWeighted(image, hardship.texture, coarse, 1.0 - hardship.texture, 0.0, image);
  }
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (int i = 0; i < hardship.highlights; ++i) {
    const double size = place(random), down = place(random), across = place(random);
    const cv::Point at(static_cast<int>(across * image.cols), static_cast<int>(down * image.rows));
    cv::circle(image, at, 3 + static_cast<int>(9.0 * size), cv::Scalar::all(252), cv::FILLED, cv::LINE_AA);
  }
  if (hardship.noise > 0.0) {
    std::normal_distribution<double> noise(0.0, hardship.noise);
    for (std::uint8_t* p = image.data; p != image.dataend; ++p)
      *p = static_cast<std::uint8_t>(std::clamp(std::lround(*p + noise(random)), 0L, 255L));
  }
  return picture_of(image);
}

Picture with_dots(const Picture& picture, const std::vector<Dot>& dots) {
  cv::Mat grey, image = view_of(picture).clone();
  if (image.channels() == 3)
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  else
    grey = image;
  cv::cvtColor(grey, image, cv::COLOR_GRAY2BGR);
  const int radius = std::max(2, picture.width / 240);
  for (const Dot& dot : dots)
    cv::circle(image, cv::Point(cvRound(dot.x), cvRound(dot.y)), radius,
               cv::Scalar(dot.blue, dot.green, dot.red), cv::FILLED, cv::LINE_AA);
  return picture_of(image);
}

}  // namespace glisson::experiments
