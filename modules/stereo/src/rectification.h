// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "glisson/geometry/camera.h"
#include "glisson/stereo/side.h"

namespace glisson::stereo {

/// Two virtual cameras without distortion, side by side (Fusiello 2000): the same point has the same row in
/// both, and columns that differ by the disparity d = f B / Z.
class Rectification {
 public:
  explicit Rectification(const StereoRig& rig);

  /// A pixel as taken to a rectified one. Empty where the calibration's distortion folds over and has no
  /// meaning.
  std::optional<Eigen::Vector2d> rectify(Side side, const Eigen::Vector2d& pixel) const;
  /// A rectified pixel to one as taken; empty for the same reason.
  std::optional<Eigen::Vector2d> unrectify(Side side, const Eigen::Vector2d& rectified) const;
  /// The picture that the virtual camera would take; black where it sees nothing. One channel; CV_32F is
  /// sampled exactly, 8 bit (masks) to a 32nd of a pixel, as OpenCV does.
  cv::Mat warp(Side side, const cv::Mat& image) const;

  /// d = f B / Z, whatever the principal points.
  double disparity(const Eigen::Vector2d& left, const Eigen::Vector2d& right) const {
    return (left.x() - centre_[0].x()) - (right.x() - centre_[1].x());
  }
  double right_column(double left_column, double disparity) const {
    return left_column - centre_[0].x() + centre_[1].x() - disparity;
  }
  /// Column in the left picture less that in the right one.
  double column_difference(double disparity) const { return disparity + centre_[0].x() - centre_[1].x(); }
  double disparity_at(double depth) const { return focal_ * baseline_ / depth; }
  /// Point in the left camera's frame, metres. @pre disparity > 0.
  Eigen::Vector3d triangulate(const Eigen::Vector2d& left, double right_row, double disparity) const;
  /// Metres along the ray for a pixel of disparity.
  double depth_per_pixel(const Eigen::Vector2d& left, double disparity) const;

  /// Of triangulate(), metres^2, in first order. @param column, row standard deviations of where the point is
  /// in the left picture; @param sigma of the disparity; pixels.
  Eigen::Matrix3d covariance(const Eigen::Vector2d& left, double disparity, double column, double row,
                             double sigma) const;

  /// Towards the camera, unit, left camera's frame, where the disparity changes by `slope` a pixel: a plane
  /// a X + b Y + c Z = f B has the disparity (a x + b y) / f + c. Facing the camera where that is no surface.
  Eigen::Vector3d normal(const Eigen::Vector2d& left, double disparity, const Eigen::Vector2d& slope) const;
  /// Prior standard deviation of the disparity's second-order coefficients, 1 / pixel, from the most curved
  /// surface that is expected: a liver's edge, with a radius of some 5 mm.
  double bend_prior() const { return baseline_ / (2.0 * focal_ * 5e-3); }

  double focal() const { return focal_; }
  double depth_at(double disparity) const { return focal_ * baseline_ / disparity; }
  int width() const { return rig_.left.width; }
  int height() const { return rig_.left.height; }

 private:
  const Camera& camera(Side side) const { return side == Side::left ? rig_.left : rig_.right; }

  StereoRig rig_;
  double focal_ = 1.0, baseline_ = 1.0;
  Eigen::Matrix3d rectified_from_[2];  ///< rotation from the left, right camera's frame
  Eigen::Vector2d centre_[2];          ///< principal points, one row
  double limit_[2] = {0.0, 0.0};       ///< |(x, y)| of a ray up to which the distortion is one-to-one
};

}  // namespace glisson::stereo
