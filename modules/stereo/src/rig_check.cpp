// SPDX-License-Identifier: GPL-3.0-or-later
#include "rig_check.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <cstdio>

#include "glisson/core/error.h"

namespace glisson::stereo {
namespace {

constexpr const char* kCalibrateAgain = "Write the calibration anew or calibrate again";

}  // namespace

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

void check_camera(const std::string& file, const std::string& field, const Camera& camera) {
  const Eigen::Matrix3d& m = camera.matrix;
  if (m(0, 0) <= 0.0 || m(1, 1) <= 0.0 || m(1, 0) != 0.0 || m(2, 0) != 0.0 || m(2, 1) != 0.0 ||
      std::abs(m(2, 2) - 1.0) > 1e-9)
    throw InputError(file, field, "is not a camera matrix (fx 0 cx; 0 fy cy; 0 0 1)", kCalibrateAgain);
  if (m(0, 2) < 0.0 || m(0, 2) > camera.width || m(1, 2) < 0.0 || m(1, 2) > camera.height)
    throw InputError(file, field,
                     "has its principal point (" + number_text(m(0, 2)) + ", " + number_text(m(1, 2)) +
                         ") outside the image of " + std::to_string(camera.width) + "x" +
                         std::to_string(camera.height),
                     "Check image_width and image_height: the calibration is of another image size");
}

Eigen::Matrix3d checked_rotation(const std::string& file, const std::string& field,
                                 const Eigen::Matrix3d& matrix) {
  if (!((matrix * matrix.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= 1e-3) ||
      matrix.determinant() <= 0.0)
    throw InputError(file, field, "is not a rotation (determinant " + number_text(matrix.determinant()) + ")",
                     kCalibrateAgain);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

void check_rig(const std::string& file, const StereoRig& rig) {
  const double baseline = rig.baseline();
  if (baseline == 0.0) throw InputError(file, "T", "is zero: the cameras have no baseline", kCalibrateAgain);
  if (baseline < kSmallestBaseline || baseline > kLargestBaseline)
    throw InputError(file, "T",
                     "gives a baseline of " + number_text(1e3 * baseline) +
                         " mm, where a stereo laparoscope has 1 to 30 mm",
                     "Check the unit");
  const double x = right_in_left(rig).x();
  if (x <= 0.0)
    throw InputError(file, "T",
                     "puts the right camera " + number_text(-1e3 * x) + " mm to the left of the left one",
                     "Left and right are swapped, or R and T map right to left: x_right = R x_left + T");
}

}  // namespace glisson::stereo
