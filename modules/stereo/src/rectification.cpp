// SPDX-License-Identifier: GPL-3.0-or-later
#include "rectification.h"

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include "sampling.h"

namespace glisson::stereo {
namespace {

/// The radius up to which the distortion keeps rays apart. Beyond it the polynomial of some calibrations
/// turns back, and two rays share a pixel.
double one_to_one_limit(const Camera& camera) {
  constexpr double kLeastSlope = 0.2, kWidest = 4.0, kStep = 1e-3;
  const auto& d = camera.distortion;
  double r = 0.0;
  for (; r < kWidest; r += kStep) {
    const double r2 = r * r;
    if (1.0 + r2 * (3.0 * d[0] + r2 * (5.0 * d[1] + r2 * 7.0 * d[4])) < kLeastSlope) break;
  }
  return r;
}

}  // namespace

Rectification::Rectification(const StereoRig& rig) : rig_(rig), baseline_(rig.baseline()) {
  const Eigen::Matrix3d& r = rig.right_from_left.rotation;
  const Eigen::Vector3d x = (-(r.transpose() * rig.right_from_left.translation)).normalized();
  const Eigen::Vector3d forward = (Eigen::Vector3d::UnitZ() + r.transpose().col(2)).normalized();
  const Eigen::Vector3d y = forward.cross(x).normalized();
  rectified_from_[0] << x.transpose(), y.transpose(), x.cross(y).transpose();
  rectified_from_[1] = rectified_from_[0] * r.transpose();
  focal_ = 0.25 *
           (rig.left.matrix(0, 0) + rig.left.matrix(1, 1) + rig.right.matrix(0, 0) + rig.right.matrix(1, 1));
  const Eigen::Vector2d middle(0.5 * (width() - 1), 0.5 * (height() - 1));
  for (const Side side : {Side::left, Side::right}) {
    const int k = side == Side::left ? 0 : 1;
    const Eigen::Vector3d ray = rectified_from_[k] * camera(side).ray(middle);
    centre_[k] = middle - focal_ * ray.hnormalized();
    limit_[k] = one_to_one_limit(camera(side));
  }
  centre_[0].y() = centre_[1].y() = 0.5 * (centre_[0].y() + centre_[1].y());
}

std::optional<Eigen::Vector2d> Rectification::rectify(Side side, const Eigen::Vector2d& pixel) const {
  const int k = side == Side::left ? 0 : 1;
  const Eigen::Vector3d ray = camera(side).ray(pixel);
  if (!ray.allFinite() || ray.head<2>().norm() > limit_[k] ||
      (camera(side).project(ray) - pixel).squaredNorm() > 1e-4)
    return std::nullopt;
  const Eigen::Vector3d turned = rectified_from_[k] * ray;
  if (turned.z() < 0.1) return std::nullopt;
  return focal_ * turned.hnormalized() + centre_[k];
}

std::optional<Eigen::Vector2d> Rectification::unrectify(Side side, const Eigen::Vector2d& rectified) const {
  const int k = side == Side::left ? 0 : 1;
  const Eigen::Vector3d ray =
      rectified_from_[k].transpose() * ((rectified - centre_[k]) / focal_).homogeneous();
  if (ray.z() < 0.1 || ray.hnormalized().norm() > limit_[k]) return std::nullopt;
  return camera(side).project(ray);
}

cv::Mat Rectification::warp(Side side, const cv::Mat& image) const {
  if (image.type() == CV_32F) {
    cv::Mat result = cv::Mat::zeros(height(), width(), CV_32F);
    for (int row = 0; row < result.rows; ++row)
      for (int column = 0; column < result.cols; ++column) {
        const auto pixel = unrectify(side, {column, row});
        if (pixel && inside_cubic(image, pixel->x(), pixel->y()))
          result.at<float>(row, column) = sample_cubic(image, pixel->x(), pixel->y());
      }
    return result;
  }
  cv::Mat map(height(), width(), CV_32FC2);
  for (int row = 0; row < map.rows; ++row)
    for (int column = 0; column < map.cols; ++column) {
      const auto pixel = unrectify(side, {column, row});
      map.at<cv::Vec2f>(row, column) =
          pixel ? cv::Vec2f(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()))
                : cv::Vec2f(-10.0F, -10.0F);
    }
  cv::Mat result;
  cv::remap(image, result, map, cv::noArray(), cv::INTER_CUBIC, cv::BORDER_CONSTANT);
  return result;
}

Eigen::Vector3d Rectification::triangulate(const Eigen::Vector2d& left, double right_row,
                                           double disparity) const {
  // Equal weight to both rows; the columns are met exactly.
  const Eigen::Vector3d ray((left.x() - centre_[0].x()) / focal_,
                            (0.5 * (left.y() + right_row) - centre_[0].y()) / focal_, 1.0);
  return rectified_from_[0].transpose() * (ray * (focal_ * baseline_ / disparity));
}

Eigen::Matrix3d Rectification::covariance(const Eigen::Vector2d& left, double disparity, double column,
                                          double row, double sigma) const {
  const double depth = depth_at(disparity);
  const Eigen::Vector3d ray = ((left - centre_[0]) / focal_).homogeneous();
  Eigen::Matrix3d jacobian;  // by column, row, disparity
  jacobian.col(0) = Eigen::Vector3d::UnitX() * (depth / focal_);
  jacobian.col(1) = Eigen::Vector3d::UnitY() * (depth / focal_);
  jacobian.col(2) = ray * (-depth / disparity);
  jacobian = rectified_from_[0].transpose() * jacobian;
  return jacobian * Eigen::Vector3d(column * column, row * row, sigma * sigma).asDiagonal() *
         jacobian.transpose();
}

Eigen::Vector3d Rectification::normal(const Eigen::Vector2d& left, double disparity,
                                      const Eigen::Vector2d& slope) const {
  const Eigen::Vector2d from_centre = left - centre_[0];
  const Eigen::Vector3d plane(focal_ * slope.x(), focal_ * slope.y(), disparity - slope.dot(from_centre));
  const Eigen::Vector3d ray = (from_centre / focal_).homogeneous().normalized();
  const Eigen::Vector3d normal = -plane.normalized();
  return rectified_from_[0].transpose() * (normal.dot(ray) < 0.0 ? normal : Eigen::Vector3d(-ray));
}

double Rectification::depth_per_pixel(const Eigen::Vector2d& left, double disparity) const {
  const Eigen::Vector2d slope = (left - centre_[0]) / focal_;
  return focal_ * baseline_ / (disparity * disparity) * slope.homogeneous().norm();
}

}  // namespace glisson::stereo
