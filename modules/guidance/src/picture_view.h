// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/imgproc.hpp>
#include <string>

#include "glisson/core/error.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

namespace glisson::guidance {

/// @throws InputError an empty picture, or one of another size than the camera's.
inline void require_view(const Picture& picture, const Camera& camera, const char* name) {
  if (picture.empty()) throw InputError(name, "picture", "is empty", "Give both views of every frame");
  if (picture.width != camera.width || picture.height != camera.height)
    throw InputError(name, "picture size",
                     "is " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                         ", the calibration's is " + std::to_string(camera.width) + " x " +
                         std::to_string(camera.height),
                     "Use the calibration of this video");
}

/// The picture's own bytes, to be read. @pre not empty.
inline cv::Mat view_of(const Picture& picture) {
  return {picture.height, picture.width, picture.channels == 1 ? CV_8UC1 : CV_8UC3,
          const_cast<std::uint8_t*>(picture.bytes->data())};
}

/// In grey: the picture's own bytes where it is grey already, else new ones.
inline cv::Mat grey_of(const Picture& picture) {
  if (picture.channels == 1) return view_of(picture);
  cv::Mat grey;
  cv::cvtColor(view_of(picture), grey, cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace glisson::guidance
