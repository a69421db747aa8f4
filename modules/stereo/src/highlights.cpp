// SPDX-License-Identifier: GPL-3.0-or-later
#include "highlights.h"

#include <opencv2/imgproc.hpp>

#include "picture_cv.h"

namespace glisson::stereo {

cv::Mat highlights(const Picture& picture) {
  constexpr int kAllChannels = 190, kGrey = 245, kAround = 2;
  const cv::Mat image = view(picture);
  cv::Mat mask;
  if (picture.channels == 1)
    mask = image >= kGrey;
  else
    cv::inRange(image, cv::Scalar::all(kAllChannels), cv::Scalar::all(255), mask);
  const cv::Mat disk =
      cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * kAround + 1, 2 * kAround + 1));
  cv::dilate(mask, mask, disk);
  return mask;
}

}  // namespace glisson::stereo
