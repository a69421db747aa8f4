// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <deque>
#include <opencv2/imgproc.hpp>

#include "glisson/stereo/faults.h"
#include "picture_cv.h"
#include "view_state.h"

namespace glisson::stereo {
namespace {

constexpr int kWidth = 96;
// Grey levels of thumbnails. A sensor's noise of one level leaves some 0.1 there.
constexpr double kSame = 0.03;
constexpr double kMoves = 0.2;
constexpr double kFrozenSeconds = 0.2;

bool without_content(const cv::Mat& view) {
  constexpr double kDark = 14.0, kBrightest = 40.0, kFlat = 2.0;
  cv::Scalar mean, deviation;
  cv::meanStdDev(view, mean, deviation);
  double brightest = 0.0;
  cv::minMaxLoc(view, nullptr, &brightest);
  return (mean[0] < kDark && brightest < kBrightest) || deviation[0] < kFlat;
}

/// What is remembered of a frame.
struct Seen {
  cv::Mat left, right;
  int index = 0;
  double seconds = 0.0;
};

double between(const Seen& a, const Seen& b) {
  return difference(a.left, b.left) + difference(a.right, b.right);
}

}  // namespace

cv::Mat thumbnail(const Picture& picture) {
  cv::Mat small, result;
  const int height = std::max(1, kWidth * picture.height / std::max(1, picture.width));
  cv::resize(grey(picture), small, cv::Size(kWidth, height), 0.0, 0.0, cv::INTER_AREA);
  small.convertTo(result, CV_32F);
  return result;
}

double difference(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() ? cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total()) : HUGE_VAL;
}

std::vector<Fault> faults_of_views(const cv::Mat& left, const cv::Mat& right) {
  const bool no_left = without_content(left), no_right = without_content(right);
  if (no_left && no_right) return {Fault::black};
  if (no_left) return {Fault::left_lost};
  if (no_right) return {Fault::right_lost};
  if (difference(left, right) < kSame) return {Fault::one_view};
  return {};
}

struct SequenceCheck::Impl {
  std::deque<Seen> seen;      ///< the last three that were sound and new, newest last
  double still_since = -1.0;  ///< when both views stopped; negative: they move

  /// Whether the frame before the last came too late: that one lies between it and its own predecessor, and
  /// the new frame goes on from the last but one.
  bool exchanged(const Seen& now) const {
    if (seen.size() < 3) return false;
    const Seen &a = seen[0], &b = seen[1], &c = seen[2];
    const double ab = between(a, b), ac = between(a, c), bn = between(b, now), cn = between(c, now);
    return ac < 0.8 * ab && bn < 0.8 * cn && ab > 2.0 * kMoves && cn > 2.0 * kMoves;
  }

  /// Each view goes on from the other's last. What is remembered was turned back: it holds in every swapped
  /// frame.
  bool crossed(const Seen& now) const {
    if (seen.empty()) return false;
    const Seen& last = seen.back();
    const double straight = between(last, now);
    const double across = difference(last.left, now.right) + difference(last.right, now.left);
    return across < 0.5 * straight && straight > 2.0 * kMoves;
  }
};

SequenceCheck::SequenceCheck() : impl_(std::make_unique<Impl>()) {}
SequenceCheck::~SequenceCheck() = default;

std::vector<FrameFault> SequenceCheck::push(const StereoFrame& frame) {
  std::vector<FrameFault> found;
  const auto say = [&](Fault fault, int index) { found.push_back({index, fault}); };
  Seen now{thumbnail(frame.left), thumbnail(frame.right), frame.index, frame.seconds};
  for (const Fault fault : faults_of_views(now.left, now.right)) say(fault, frame.index);
  if (!found.empty()) return found;
  auto& seen = impl_->seen;
  if (impl_->crossed(now)) {
    say(Fault::swapped, frame.index);
    std::swap(now.left, now.right);
  }
  if (!seen.empty()) {
    const bool left_still = difference(seen.back().left, now.left) < kSame;
    const bool right_still = difference(seen.back().right, now.right) < kSame;
    if (left_still && right_still) {
      if (impl_->still_since < 0.0) impl_->still_since = seen.back().seconds;
      const bool frozen = frame.seconds - impl_->still_since >= kFrozenSeconds;
      say(frozen ? Fault::frozen : Fault::duplicated, frame.index);
      return found;  // nothing new to remember
    }
    impl_->still_since = -1.0;
    const double left_moves = difference(seen.back().left, now.left);
    const double right_moves = difference(seen.back().right, now.right);
    if (left_still && right_moves > kMoves) say(Fault::left_frozen, frame.index);
    if (right_still && left_moves > kMoves) say(Fault::right_frozen, frame.index);
  }
  if (impl_->exchanged(now)) {
    say(Fault::out_of_order, seen.back().index);
    std::swap(seen[1], seen[2]);  // as they should have come
  }
  seen.push_back(std::move(now));
  if (seen.size() > 3) seen.pop_front();
  return found;
}

}  // namespace glisson::stereo
