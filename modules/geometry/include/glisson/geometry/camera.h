// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "glisson/geometry/rigid.h"

namespace glisson {

/// A pinhole with Brown's distortion, OpenCV's convention: x right, y down, z forward; pixel (0, 0) is the
/// centre of the first pixel.
struct Camera {
  int width = 0, height = 0;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();  ///< fx 0 cx; 0 fy cy; 0 0 1, pixels
  /// k1 k2 p1 p2 k3.
  Eigen::Matrix<double, 5, 1> distortion = Eigen::Matrix<double, 5, 1>::Zero();

  /// Whether a point in the camera's frame lies before the lens and where the lens keeps directions apart.
  /// The polynomial of many calibrations turns back outside of the picture, of some within it: from there on
  /// project() gives the pixel of something else. Where a step outwards has shrunk to a fifth of what it is
  /// in the middle, a pixel tells nearly nothing of a direction: that is the limit. By the radial terms
  /// alone.
  bool maps(const Eigen::Vector3d& p_in_camera) const;
  /// The tangent of the angle from the axis up to which maps() holds; 4 where it holds everywhere.
  double widest_slope() const;
  /// Whether a point in the camera's frame is in the picture: maps(), and within the borders.
  bool shows(const Eigen::Vector3d& p_in_camera) const {
    return maps(p_in_camera) && sees(project(p_in_camera));
  }

  /// Pixel of a point in the camera's frame (metres; only directions matter). @pre z > 0.
  Eigen::Vector2d project(const Eigen::Vector3d& p_in_camera) const;
  /// The ray (x, y, 1) through a pixel, distortion removed by Newton's method. Beyond where the distortion
  /// turns back a pixel has none: it gets the outermost one that maps() on its side, which is finite and is
  /// projected elsewhere. Whoever may meet such a pixel asks mapped_ray(). @pre a finite pixel.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;
  /// The same where the lens maps it (maps()) to the pixel; empty: nothing that the camera sees is there.
  std::optional<Eigen::Vector3d> mapped_ray(const Eigen::Vector2d& pixel) const;
  /// Whether a pixel is within the borders. Of a point, ask shows().
  bool sees(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 && pixel.y() < height - 0.5;
  }
};

/// The same lens before a chip of wider pixels, each of which stands for `times` x `times` of the camera's:
/// what a picture shows of which so many pixels were averaged. What is left over on the right and below is
/// cut off.
/// @pre times is 1 or more
Camera reduced(const Camera& camera, int times);
/// By which whole number pictures of that width are made smaller before they are followed and drawn over: 1
/// up to 1919 pixels, 2 from 1920 on, 4 from 3840 on.
int reduction_of(int width);

/// A calibrated stereo laparoscope.
struct StereoRig {
  Camera left, right;
  /// x_right = R x_left + T, metres.
  Rigid<RightCameraFrame, CameraFrame> right_from_left;

  double baseline() const { return right_from_left.translation.norm(); }
};

}  // namespace glisson
