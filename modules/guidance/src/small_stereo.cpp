// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_stereo.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "disparity_fit.h"
#include "picture_view.h"

namespace glisson::guidance {
namespace {

constexpr int kBlock = 7;  ///< pixels of the reduced pictures
/// Pixels of the reduced pictures: what a disparity errs besides noise (lens, whole pixels).
constexpr double kDisparitySigma = 0.25;
constexpr int kShare = 16;  ///< of a pixel, OpenCV's unit of disparities

cv::Mat matrix(const Eigen::Matrix3d& from) {
  cv::Mat to(3, 3, CV_64F);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) to.at<double>(i, j) = from(i, j);
  return to;
}
cv::Mat coefficients(const Camera& camera) {
  cv::Mat to(1, 5, CV_64F);
  for (int i = 0; i < 5; ++i) to.at<double>(0, i) = camera.distortion[i];
  return to;
}
Eigen::Matrix3d eigen(const cv::Mat& from) {
  Eigen::Matrix3d to;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) to(i, j) = from.at<double>(i, j);
  return to;
}

}  // namespace

struct SmallStereo::Impl {
  cv::Mat map_left[2], map_right[2];
  Eigen::Matrix3d rectified_from_left = Eigen::Matrix3d::Identity();
  double focal = 1.0, cx = 0.0, cy = 0.0, offset = 0.0, baseline = 1.0;
  cv::Ptr<cv::StereoSGBM> matcher;
  cv::Mat left, right, disparity;

  static void rectified(const Picture& picture, const Camera& camera, const char* name, const cv::Mat* map,
                        cv::Mat& out) {
    require_view(picture, camera, name);
    cv::remap(grey_of(picture), out, map[0], map[1], cv::INTER_LINEAR);
  }
};

SmallStereo::SmallStereo(const StereoRig& rig, int width, int step, double near, double far)
    : rig_(rig), step_(step), impl_(std::make_unique<Impl>()) {
  const double scale = std::min(1.0, static_cast<double>(width) / rig.left.width);
  const cv::Size whole(rig.left.width, rig.left.height),
      small(static_cast<int>(rig.left.width * scale), static_cast<int>(rig.left.height * scale));
  cv::Mat turn_left, turn_right, project_left, project_right, q, t(3, 1, CV_64F);
  for (int i = 0; i < 3; ++i) t.at<double>(i) = rig.right_from_left.translation[i];
  const cv::Mat k_left = matrix(rig.left.matrix), k_right = matrix(rig.right.matrix);
  cv::stereoRectify(k_left, coefficients(rig.left), k_right, coefficients(rig.right), whole,
                    matrix(rig.right_from_left.rotation), t, turn_left, turn_right, project_left,
                    project_right, q, 0, 0.0, small);
  cv::initUndistortRectifyMap(k_left, coefficients(rig.left), turn_left, project_left, small, CV_16SC2,
                              impl_->map_left[0], impl_->map_left[1]);
  cv::initUndistortRectifyMap(k_right, coefficients(rig.right), turn_right, project_right, small, CV_16SC2,
                              impl_->map_right[0], impl_->map_right[1]);
  impl_->rectified_from_left = eigen(turn_left);
  impl_->focal = project_left.at<double>(0, 0);
  impl_->cx = project_left.at<double>(0, 2);
  impl_->cy = project_left.at<double>(1, 2);
  impl_->offset = impl_->cx - project_right.at<double>(0, 2);
  impl_->baseline = std::abs(project_right.at<double>(0, 3)) / impl_->focal;
  const auto disparity = [&](double z) { return impl_->focal * impl_->baseline / z + impl_->offset; };
  const int least = static_cast<int>(std::floor(disparity(far)));
  const int span = 16 * static_cast<int>(std::ceil((disparity(near) - least + 1.0) / 16.0));
  impl_->matcher =
      cv::StereoSGBM::create(least, std::max(16, span), kBlock, 8 * kBlock * kBlock, 32 * kBlock * kBlock, 1,
                             31, 10, 60, 2, cv::StereoSGBM::MODE_SGBM_3WAY);

  columns_ = small.width / step;
  rows_ = small.height / step;
  const Eigen::Matrix3d back = impl_->rectified_from_left.transpose();
  for (int r = 0; r < rows_; ++r)
    for (int c = 0; c < columns_; ++c) {
      const double x = (c + 0.5) * step, y = (r + 0.5) * step;
      const Eigen::Vector3d ray =
          back * Eigen::Vector3d((x - impl_->cx) / impl_->focal, (y - impl_->cy) / impl_->focal, 1.0);
      rays_.push_back(ray.normalized());
      pixels_.push_back(ray.z() > 0.0 ? rig.left.project(ray) : Eigen::Vector2d(-1e3, -1e3));
    }
}

SmallStereo::~SmallStereo() = default;

const Eigen::Vector3d& SmallStereo::ray(int column, int row) const {
  return rays_[static_cast<std::size_t>(row * columns_ + column)];
}
const Eigen::Vector2d& SmallStereo::pixel(int column, int row) const {
  return pixels_[static_cast<std::size_t>(row * columns_ + column)];
}

std::optional<std::pair<int, int>> SmallStereo::place(const Eigen::Vector3d& p_in_camera) const {
  const Eigen::Vector3d p = impl_->rectified_from_left * p_in_camera;
  if (!(p.z() > 0.0)) return std::nullopt;
  const double c = (impl_->focal * p.x() / p.z() + impl_->cx) / step_,
               r = (impl_->focal * p.y() / p.z() + impl_->cy) / step_;
  if (!(c >= 0.0 && r >= 0.0 && c < columns_ && r < rows_)) return std::nullopt;
  return std::pair{static_cast<int>(c), static_cast<int>(r)};
}

std::vector<SeenPoint> SmallStereo::see(const Picture& left, const Picture& right) {
  Impl::rectified(left, rig_.left, "left view", impl_->map_left, impl_->left);
  Impl::rectified(right, rig_.right, "right view", impl_->map_right, impl_->right);
  impl_->matcher->compute(impl_->left, impl_->right, impl_->disparity);
  const int nothing = (impl_->matcher->getMinDisparity() - 1) * kShare;
  const Eigen::Matrix3d back = impl_->rectified_from_left.transpose();
  std::vector<SeenPoint> seen;
  for (int r = 0; r < rows_; ++r)
    for (int c = 0; c < columns_; ++c) {
      const int x = c * step_ + step_ / 2, y = r * step_ + step_ / 2;
      const int raw = impl_->disparity.at<std::int16_t>(y, x);
      if (raw <= nothing) continue;
      const auto fit = fit_disparity(impl_->left, impl_->right, x, y, raw / static_cast<double>(kShare));
      if (!fit) continue;
      const double d = fit->disparity - impl_->offset;
      if (d <= 0.5) continue;
      const double z = impl_->focal * impl_->baseline / d;
      SeenPoint point;
      point.column = c;
      point.row = r;
      point.p_in_camera =
          back * (z * Eigen::Vector3d((x - impl_->cx) / impl_->focal, (y - impl_->cy) / impl_->focal, 1.0));
      point.sigma = point.p_in_camera.norm() / d * std::hypot(kDisparitySigma, fit->sigma);
      seen.push_back(point);
    }
  return seen;
}

}  // namespace glisson::guidance
