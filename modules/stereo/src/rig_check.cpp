// SPDX-License-Identifier: GPL-3.0-or-later
#include "rig_check.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glisson/core/error.h"

namespace glisson::stereo {
namespace {

constexpr const char* kCalibrateAgain = "Write the calibration anew or calibrate again";

/// A pixel's place on the plane z = 1, distorted as it is.
Eigen::Vector2d on_plane(const Camera& camera, double u, double v) {
  return {(u - camera.matrix(0, 2)) / camera.matrix(0, 0), (v - camera.matrix(1, 2)) / camera.matrix(1, 1)};
}

/// How far the radial terms move a point at this slope, on the plane z = 1; outwards is positive.
double radial_shift(const Camera& camera, double slope) {
  const auto& d = camera.distortion;
  const double u = slope * slope;
  return slope * u * (d[0] + u * (d[1] + u * d[4]));
}

}  // namespace

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

void check_camera(const std::string& file, const std::string& field, const Camera& camera) {
  const Eigen::Matrix3d& m = camera.matrix;
  if (m(0, 2) == 0.0 && m(1, 2) == 0.0 && m(2, 0) > 0.0 && m(2, 1) > 0.0)
    throw InputError(file, field, "is transposed: it has cx and cy in its last row",
                     "Write rows as columns, in R too; MATLAB counts pixels from 1: take 1 off cx and cy");
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

Camera without_skew(const std::string& file, const std::string& field, Camera camera) {
  constexpr double kLargestShift = 0.1;  // pixels: what corners are found to
  const Eigen::Matrix3d& m = camera.matrix;
  const double rows = std::max(m(1, 2), camera.height - m(1, 2)), shift = std::abs(m(0, 1)) * rows / m(1, 1);
  if (!(shift <= kLargestShift))
    throw InputError(file, field,
                     "has a skew of " + number_text(m(0, 1)) +
                         " (row 1, column 2), which moves pixels by up to " + number_text(shift) +
                         " px and is not computed with",
                     "Calibrate without skew, which no chip has (fx 0 cx; 0 fy cy; 0 0 1)");
  camera.matrix(0, 1) = 0.0;
  return camera;
}

void check_distortion(const std::string& file, const std::string& field, const Camera& camera) {
  constexpr double kShareOfWidth = 0.01, kShareOfRadial = 0.5;
  constexpr int kSlopes = 50;
  double widest = 0.0;
  for (const double u : {0.0, camera.width - 1.0})
    for (const double v : {0.0, camera.height - 1.0})
      widest = std::max(widest, on_plane(camera, u, v).norm());
  widest = std::min(widest, camera.widest_slope());
  double radial = 0.0;
  for (int n = 1; n <= kSlopes; ++n)
    radial = std::max(radial, std::abs(radial_shift(camera, widest * n / kSlopes)));
  const double tangential = 3.0 * camera.distortion.segment<2>(2).norm() * widest * widest,
               focal = std::max(camera.matrix(0, 0), camera.matrix(1, 1));
  if (focal * tangential <= kShareOfWidth * camera.width || tangential <= kShareOfRadial * radial) return;
  throw InputError(file, field,
                   "moves pixels by up to " + number_text(focal * tangential) +
                       " px by its tangential terms p1 p2, and by " + number_text(focal * radial) +
                       " px by its radial ones, which no lens does",
                   "Write k1 k2 p1 p2 k3 in this order (MATLAB has k1 k2 k3 apart), or calibrate again");
}

double share_without_rays(const Camera& camera) {
  constexpr int kStep = 4;  // pixels: a share needs no more
  const double slope = camera.widest_slope();
  const double reach = slope + radial_shift(camera, slope);
  int all = 0, beyond = 0;
  for (int v = 0; v < camera.height; v += kStep)
    for (int u = 0; u < camera.width; u += kStep, ++all) beyond += on_plane(camera, u, v).norm() > reach;
  return static_cast<double>(beyond) / std::max(1, all);
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
