// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduced_views.h"

#include <opencv2/imgproc.hpp>

#include "picture_view.h"

namespace glisson::guidance {
namespace {

/// What is left of whole blocks of `times` pixels.
cv::Mat blocks_of(const Picture& picture, const Camera& small, int times) {
  return view_of(picture)(cv::Rect(0, 0, small.width * times, small.height * times));
}

Picture picture_of(const cv::Mat& whole_rows) {
  return {whole_rows.cols, whole_rows.rows, whole_rows.channels(),
          std::make_shared<std::vector<std::uint8_t>>(whole_rows.datastart, whole_rows.dataend)};
}

bool fits(const Picture& picture, const Camera& camera) {
  return !picture.empty() && picture.width == camera.width && picture.height == camera.height;
}

}  // namespace

ReducedViews::ReducedViews(const StereoRig& rig)
    : whole_(rig), small_(rig), times_(reduction_of(rig.left.width)) {
  small_.left = glisson::reduced(rig.left, times_);
  small_.right = glisson::reduced(rig.right, times_);
}

void ReducedViews::require_frame(const StereoFrame& frame) const {
  require_view(frame.left, whole_.left, "left view");
  require_view(frame.right, whole_.right, "right view");
}

Picture ReducedViews::reduced(const Picture& picture, const Camera& camera) const {
  if (!fits(picture, camera)) return {};
  const Camera& small = &camera == &whole_.left ? small_.left : small_.right;
  const int type = picture.channels == 1 ? CV_8UC1 : CV_8UC3;
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(small.width) *
                                                           static_cast<std::size_t>(small.height) *
                                                           static_cast<std::size_t>(picture.channels));
  cv::Mat to(small.height, small.width, type, bytes->data());
  cv::resize(blocks_of(picture, small, times_), to, to.size(), 0, 0, cv::INTER_AREA);
  return {small.width, small.height, picture.channels, std::move(bytes)};
}

StereoFrame ReducedViews::reduced(const StereoFrame& frame) const {
  if (times_ == 1) return frame;
  return {reduced(frame.left, whole_.left), reduced(frame.right, whole_.right), frame.index, frame.seconds};
}

Picture ReducedViews::reduced_mask(const Picture& mask) const {
  if (mask.empty()) return mask;
  require_view(mask, whole_.left, "mask");
  if (times_ == 1) return mask;
  cv::Mat most;
  cv::dilate(grey_of(mask), most, cv::Mat::ones(times_, times_, CV_8U), cv::Point(0, 0));
  cv::Mat small(small_.left.height, small_.left.width, CV_8UC1);
  for (int y = 0; y < small.rows; ++y)
    for (int x = 0; x < small.cols; ++x)
      small.at<std::uint8_t>(y, x) = most.at<std::uint8_t>(y * times_, x * times_);
  return picture_of(small);
}

std::shared_ptr<const PictureMask> ReducedViews::reduced(
    const std::shared_ptr<const PictureMask>& mask) const {
  if (!mask || !fits(mask->not_liver, whole_.left)) return nullptr;
  if (times_ == 1) return mask;
  return std::make_shared<PictureMask>(
      PictureMask{reduced_mask(mask->not_liver), mask->index, mask->seconds});
}

}  // namespace glisson::guidance
