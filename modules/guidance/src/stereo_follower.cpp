// SPDX-License-Identifier: GPL-3.0-or-later
#include "stereo_follower.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <thread>

#include "glisson/core/error.h"
#include "picture_view.h"
#include "triangulate.h"

namespace glisson::guidance {
namespace {

/// Grey levels from which a pixel is a highlight: it belongs to the lamp, not to the tissue.
constexpr int kHighlight = 245;

struct View {
  cv::Mat grey;
  std::vector<cv::Mat> pyramid;
};

void to_grey(const Picture& picture, const Camera& camera, const char* name, cv::Mat& grey) {
  if (picture.empty()) throw InputError(name, "picture", "is empty", "Give both views of every frame");
  if (picture.width != camera.width || picture.height != camera.height)
    throw InputError(name, "picture size",
                     "is " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                         ", the calibration's is " + std::to_string(camera.width) + " x " +
                         std::to_string(camera.height),
                     "Use the calibration of this video");
  if (picture.channels == 1)
    view_of(picture).copyTo(grey);
  else
    cv::cvtColor(view_of(picture), grey, cv::COLOR_BGR2GRAY);
}

/// Into buffers that are used again: fresh ones would cost milliseconds of page faults a frame.
void make_view(const Picture& picture, const Camera& camera, const char* name, const FollowerOptions& options,
               View& view) {
  to_grey(picture, camera, name, view.grey);
  cv::buildOpticalFlowPyramid(view.grey, view.pyramid, cv::Size(options.window_px, options.window_px),
                              options.levels - 1, true);
}

/// Lucas-Kanade there and back. `to` holds first guesses when `guessed`.
std::vector<char> follow_both_ways(const View& from, const View& next, const std::vector<cv::Point2f>& start,
                                   std::vector<cv::Point2f>& to, bool guessed,
                                   const FollowerOptions& options) {
  std::vector<char> good(start.size(), 0);
  if (start.empty()) return good;
  const cv::Size window(options.window_px, options.window_px);
  const cv::TermCriteria stop(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 20, 0.02);
  std::vector<std::uint8_t> there, back;
  std::vector<float> error;
  std::vector<cv::Point2f> returned = start;
  cv::calcOpticalFlowPyrLK(from.pyramid, next.pyramid, start, to, there, error, window, options.levels - 1,
                           stop, guessed ? cv::OPTFLOW_USE_INITIAL_FLOW : 0, 1e-3);
  cv::calcOpticalFlowPyrLK(next.pyramid, from.pyramid, to, returned, back, error, window, options.levels - 1,
                           stop, cv::OPTFLOW_USE_INITIAL_FLOW, 1e-3);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const cv::Point2f gap = returned[i] - start[i];
    good[i] = there[i] != 0 && back[i] != 0 &&
              std::hypot(gap.x, gap.y) <= static_cast<float>(options.forward_backward_px);
  }
  return good;
}

std::vector<cv::Point2f> pixels(const std::vector<FollowedPoint>& points, bool left) {
  std::vector<cv::Point2f> result;
  result.reserve(points.size());
  for (const FollowedPoint& point : points) {
    const Eigen::Vector2d& p = left ? point.left : point.right;
    result.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  }
  return result;
}

Eigen::Vector2d pixel(const cv::Point2f& p) { return {p.x, p.y}; }

}  // namespace

struct StereoFollower::Images {
  View left, right, left_before, right_before;
  cv::Mat mask;
};

StereoFollower::StereoFollower(const StereoRig& rig, const FollowerOptions& options)
    : rig_(rig), options_(options), images_(std::make_unique<Images>()) {}

StereoFollower::~StereoFollower() = default;

void StereoFollower::begin(const StereoFrame& first, const Picture& mask) {
  make_view(first.left, rig_.left, "left view", options_, images_->left);
  make_view(first.right, rig_.right, "right view", options_, images_->right);
  images_->mask.release();
  if (!mask.empty()) to_grey(mask, rig_.left, "mask", images_->mask);
  points_.clear();
  before_.clear();
}

StereoFollower::Counts StereoFollower::follow(const StereoFrame& frame) {
  before_ = points_;
  std::swap(images_->left_before, images_->left);
  std::swap(images_->right_before, images_->right);
  std::vector<cv::Point2f> left, right;
  std::vector<char> good_left, good_right;
  const auto one_side = [&](bool is_left) {
    View& now = is_left ? images_->left : images_->right;
    make_view(is_left ? frame.left : frame.right, is_left ? rig_.left : rig_.right,
              is_left ? "left view" : "right view", options_, now);
    auto& to = is_left ? left : right;
    to.clear();
    (is_left ? good_left : good_right) =
        follow_both_ways(is_left ? images_->left_before : images_->right_before, now,
                         pixels(points_, is_left), to, false, options_);
  };
  {
    std::exception_ptr failure;
    std::jthread other([&] {
      try {
        one_side(false);
      } catch (...) {
        failure = std::current_exception();
      }
    });
    one_side(true);
    other.join();
    if (failure) std::rethrow_exception(failure);
  }
  Counts counts;
  std::vector<FollowedPoint> kept;
  kept.reserve(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    counts.left += good_left[i];
    counts.right += good_right[i];
    if (good_left[i] == 0 || good_right[i] == 0) continue;
    FollowedPoint point = points_[i];
    point.left = pixel(left[i]);
    point.right = pixel(right[i]);
    if (!rig_.left.sees(point.left) || !rig_.right.sees(point.right)) continue;
    const Triangulated in_space = triangulate(rig_, point.left, point.right);
    if (!in_space.good || in_space.epipolar_px > options_.epipolar_px) continue;
    point.p_in_camera = in_space.p;
    point.information = in_space.information;
    kept.push_back(point);
  }
  points_ = std::move(kept);
  return counts;
}

void StereoFollower::keep(const std::vector<char>& kept) {
  require(kept.size() == points_.size(), "one decision a point");
  std::size_t next = 0;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (kept[i] != 0) points_[next++] = points_[i];
  points_.resize(next);
}

void StereoFollower::forget_last() {
  points_ = before_;
  std::swap(images_->left_before, images_->left);
  std::swap(images_->right_before, images_->right);
}

int StereoFollower::replenish(const Expected& expected) {
  const int wanted = options_.points - static_cast<int>(points_.size());
  if (wanted <= 0) return 0;
  const View& left = images_->left;
  // Corners are looked for at half the size: a quarter of the time, and Lucas-Kanade needs no better place.
  cv::Mat half, allowed;
  cv::resize(left.grey, half, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
  cv::compare(half, kHighlight, allowed, cv::CMP_LT);
  cv::erode(allowed, allowed, cv::Mat(), cv::Point(-1, -1), 3);
  if (!images_->mask.empty()) {
    cv::Mat mask;
    cv::resize(images_->mask, mask, half.size(), 0, 0, cv::INTER_NEAREST);
    allowed &= mask > 0;
  }
  const double spacing = 0.4 * std::sqrt(static_cast<double>(left.grey.total()) / options_.points);
  for (const FollowedPoint& point : points_)
    cv::circle(allowed, cv::Point(static_cast<int>(point.left.x() / 2), static_cast<int>(point.left.y() / 2)),
               static_cast<int>(spacing / 2), cv::Scalar(0), cv::FILLED);
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(half, corners, 3 * wanted, 0.01, spacing / 2, allowed, 5);

  std::vector<cv::Point2f> start, guess;
  for (const cv::Point2f& corner : corners) {
    const Eigen::Vector2d at(2.0 * corner.x + 0.5, 2.0 * corner.y + 0.5);
    const auto p = expected(at);
    if (!p) continue;
    const Eigen::Vector3d in_right = rig_.right_from_left.rotation * *p + rig_.right_from_left.translation;
    if (in_right.z() <= 0.0) continue;
    const Eigen::Vector2d there = rig_.right.project(in_right);
    if (!rig_.right.sees(there)) continue;
    start.emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()));
    guess.emplace_back(static_cast<float>(there.x()), static_cast<float>(there.y()));
  }
  const std::vector<char> good = follow_both_ways(left, images_->right, start, guess, true, options_);
  int added = 0;
  for (std::size_t i = 0; i < start.size() && added < wanted; ++i) {
    if (good[i] == 0) continue;
    FollowedPoint point;
    point.left = pixel(start[i]);
    point.right = pixel(guess[i]);
    const Triangulated in_space = triangulate(rig_, point.left, point.right);
    if (!in_space.good || in_space.epipolar_px > options_.epipolar_px) continue;
    point.id = next_id_++;
    point.p_in_camera = in_space.p;
    point.information = in_space.information;
    points_.push_back(point);
    ++added;
  }
  return added;
}

}  // namespace glisson::guidance
