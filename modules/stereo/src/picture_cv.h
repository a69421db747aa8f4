// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>

#include "glisson/patient/picture.h"

namespace glisson::stereo {

/// A view of the picture's bytes; they must outlive it, and nobody writes to it.
cv::Mat view(const Picture& picture);
/// Copies an 8-bit image of 1 or 3 channels.
Picture to_picture(const cv::Mat& image);
/// The rows of one field (first 0: even, 1: odd), those between interpolated (cubic) from them: where
/// something moves, the two fields show it in two places. 8 bit.
cv::Mat one_field(const cv::Mat& image, int first);
/// One channel, 8 bit.
cv::Mat grey(const Picture& picture);
/// The same, CV_32F, not rounded: matches are refined to hundredths of a pixel.
cv::Mat grey_float(const Picture& picture);

}  // namespace glisson::stereo
