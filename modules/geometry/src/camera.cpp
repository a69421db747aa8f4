// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/camera.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"

namespace glisson {
namespace {

Eigen::Vector2d distort(const Eigen::Matrix<double, 5, 1>& d, const Eigen::Vector2d& p,
                        Eigen::Matrix2d* jacobian) {
  const double x = p.x(), y = p.y(), r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]));
  if (jacobian != nullptr) {
    const double slope = 2.0 * (d[0] + r2 * (2.0 * d[1] + 3.0 * r2 * d[4]));  // d radial / d r2, times 2
    (*jacobian)(0, 0) = radial + x * x * slope + 2.0 * d[2] * y + 6.0 * d[3] * x;
    (*jacobian)(0, 1) = x * y * slope + 2.0 * d[2] * x + 2.0 * d[3] * y;
    (*jacobian)(1, 0) = (*jacobian)(0, 1);
    (*jacobian)(1, 1) = radial + y * y * slope + 6.0 * d[2] * y + 2.0 * d[3] * x;
  }
  return {x * radial + 2.0 * d[2] * x * y + d[3] * (r2 + 2.0 * x * x),
          y * radial + d[2] * (r2 + 2.0 * y * y) + 2.0 * d[3] * x * y};
}

/// By how much a step outwards at a slope whose square is u moves on the picture, over what it does in the
/// middle: the least from the middle to there.
double least_growth(const Eigen::Matrix<double, 5, 1>& d, double u) {
  const auto growth = [&d](double v) { return 1.0 + v * (3.0 * d[0] + v * (5.0 * d[1] + v * 7.0 * d[4])); };
  double least = std::min(1.0, growth(u));
  const auto look = [&](double v) {
    if (v > 0.0 && v < u) least = std::min(least, growth(v));
  };
  // Where the cubic is flat: a + 2 b v + c v^2 = 0, written so that c may be 0.
  const double a = 3.0 * d[0], b = 5.0 * d[1], c = 21.0 * d[4], inside = b * b - a * c;
  if (!(inside >= 0.0)) return least;
  const double q = -(b + std::copysign(std::sqrt(inside), b));
  if (c != 0.0) look(q / c);
  if (q != 0.0) look(a / q);
  return least;
}

constexpr double kLeastGrowth = 0.2, kWidest = 4.0;

/// By Newton's method from a start. Where the distortion turns back it comes to nothing, or to another place.
Eigen::Vector2d undistorted(const Eigen::Matrix<double, 5, 1>& d, const Eigen::Vector2d& target,
                            const Eigen::Vector2d& start) {
  Eigen::Vector2d p = start;
  for (int pass = 0; pass < 20; ++pass) {
    Eigen::Matrix2d jacobian;
    const Eigen::Vector2d miss = distort(d, p, &jacobian) - target;
    if (miss.squaredNorm() < 1e-24) break;
    p -= jacobian.inverse() * miss;
  }
  return p;
}

/// Whether a place is distorted to the target, and lies before the distortion turns back for the first time.
bool is_first_at(const Eigen::Matrix<double, 5, 1>& d, const Eigen::Vector2d& p,
                 const Eigen::Vector2d& target) {
  constexpr double kSame = 1e-8;
  return p.allFinite() && (distort(d, p, nullptr) - target).norm() < kSame &&
         least_growth(d, p.squaredNorm()) > 0.0;
}

/// Towards the target, as far out as the radial terms alone put it, and at most `widest`.
Eigen::Vector2d by_radial_terms(const Eigen::Matrix<double, 5, 1>& d, const Eigen::Vector2d& target,
                                double widest) {
  constexpr int kHalvings = 50;
  double within = 0.0, beyond = widest;
  for (int n = 0; n < kHalvings; ++n) {
    const double slope = 0.5 * (within + beyond), u = slope * slope;
    const double seen_at = slope * (1.0 + u * (d[0] + u * (d[1] + u * d[4])));
    (seen_at < target.norm() ? within : beyond) = slope;
  }
  return beyond * target.normalized();
}

}  // namespace

bool Camera::maps(const Eigen::Vector3d& p) const {
  if (!(p.z() > 0.0) || !p.allFinite()) return false;
  const double u = p.head<2>().squaredNorm() / (p.z() * p.z());
  return u < kWidest * kWidest && least_growth(distortion, u) >= kLeastGrowth;
}

double Camera::widest_slope() const {
  constexpr int kHalvings = 50;
  double within = 0.0, beyond = kWidest;
  for (int n = 0; n < kHalvings; ++n) {
    const double slope = 0.5 * (within + beyond);
    (least_growth(distortion, slope * slope) >= kLeastGrowth ? within : beyond) = slope;
  }
  return beyond;
}

Eigen::Vector2d Camera::project(const Eigen::Vector3d& p_in_camera) const {
  const Eigen::Vector2d q = distort(distortion, p_in_camera.head<2>() / p_in_camera.z(), nullptr);
  return {matrix(0, 0) * q.x() + matrix(0, 1) * q.y() + matrix(0, 2), matrix(1, 1) * q.y() + matrix(1, 2)};
}

Eigen::Vector3d Camera::ray(const Eigen::Vector2d& pixel) const {
  const double y = (pixel.y() - matrix(1, 2)) / matrix(1, 1);
  const Eigen::Vector2d target((pixel.x() - matrix(0, 2) - matrix(0, 1) * y) / matrix(0, 0), y);
  Eigen::Vector2d p = undistorted(distortion, target, target);
  if (!is_first_at(distortion, p, target)) {
    const Eigen::Vector2d start = by_radial_terms(distortion, target, widest_slope());
    p = undistorted(distortion, target, start);
    if (!is_first_at(distortion, p, target)) p = start;
  }
  return {p.x(), p.y(), 1.0};
}

std::optional<Eigen::Vector3d> Camera::mapped_ray(const Eigen::Vector2d& pixel) const {
  constexpr double kSame = 0.01;  // pixels
  const Eigen::Vector3d found = ray(pixel);
  if (!maps(found) || !((project(found) - pixel).norm() < kSame)) return std::nullopt;
  return found;
}

Camera reduced(const Camera& camera, int times) {
  require(times >= 1, "a camera is reduced by a whole number");
  Camera small = camera;
  small.width = camera.width / times;
  small.height = camera.height / times;
  // Pixel (0, 0) is a pixel's centre: that of `times` side by side lies half of the others farther on.
  small.matrix.topRows<2>() /= times;
  small.matrix.topRightCorner<2, 1>().array() -= 0.5 * (times - 1) / times;
  return small;
}

int reduction_of(int width) {
  constexpr int kUsual = 960;
  return std::max(1, width / kUsual);
}

}  // namespace glisson
