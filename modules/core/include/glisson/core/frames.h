// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

/// @file
/// Coordinate frames as types: a point in the CT cannot be passed where one in the camera is meant.

namespace glisson {

/// The patient in the scanner: LPS axes (x to the patient's Left, y to Posterior, z to Superior), metres.
struct CtFrame {
  static constexpr const char* kName = "ct";
};
/// The left camera as calibrated (not rectified), OpenCV's axes: x right, y down, z forward, metres.
struct CameraFrame {
  static constexpr const char* kName = "camera";
};
/// The right camera, same axes: x_right = R x_left + T.
struct RightCameraFrame {
  static constexpr const char* kName = "right_camera";
};

/// A point in a frame, metres.
template <class Frame>
struct Point {
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();

  Point() = default;
  explicit Point(const Eigen::Vector3d& coordinates) : xyz(coordinates) {}
  Point(double x, double y, double z) : xyz(x, y, z) {}
};

}  // namespace glisson
