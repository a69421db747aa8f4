// SPDX-License-Identifier: GPL-3.0-or-later
#include "few_points.h"

#include <algorithm>

#include "glisson/core/error.h"
#include "picture_check.h"

namespace glisson::guidance {
namespace {

constexpr int kWidth = 320, kStep = 8;  ///< of the reduced pictures, and of the grid there
/// Of the better view's detail: with less, something is wrong with that view alone. Light and smoke, which
/// both views share, take about the same of both.
constexpr double kAlone = 0.5;
constexpr double kLookEvery = 0.3;  ///< seconds between two looks at whether the views are swapped
/// In the right order stereo sees more than the share kSeen of the places at the start, and more than kTimes
/// as many as in the other order. There it matches repeating patterns by chance.
constexpr double kSeen = 0.4, kTimes = 2.0;

}  // namespace

FewPoints::FewPoints(const StereoRig& rig, const StereoFrame& first, const JudgeOptions& options)
    : options_(options),
      stereo_(rig, kWidth, kStep, SmallStereo::kNear, SmallStereo::kFar),
      left_(signal_at_start(first.left, options.least_signal)),
      right_(signal_at_start(first.right, options.least_signal)),
      seen_(stereo_.see(first.left, first.right).size()),
      tells_order_(fits(seen_, first.left, first.right)) {}

bool FewPoints::fits(std::size_t seen, const Picture& left, const Picture& right) {
  const auto places = static_cast<double>(seen);
  return places > kSeen * static_cast<double>(seen_) &&
         places > kTimes * static_cast<double>(stereo_.see(right, left).size());
}

bool FewPoints::are_swapped(const StereoFrame& frame, const FrameClock& clock) {
  if (!tells_order_) return false;
  if (looked_ >= 0.0 && !clock.is_due(looked_, kLookEvery)) return swapped_;
  looked_ = clock.now();
  swapped_ = fits(stereo_.see(frame.right, frame.left).size(), frame.right, frame.left);
  return swapped_;
}

Validity FewPoints::reason(const StereoFrame& frame, const FrameClock& clock) {
  const Picture &left_view = frame.left, &right_view = frame.right;
  if (left_view.empty() != right_view.empty()) return Validity::view_lost;
  if (left_view.empty() || left_view.width != right_view.width || left_view.height != right_view.height)
    return Validity::too_few_points;
  const double left = measure(left_view).signal() / left_, right = measure(right_view).signal() / right_;
  const double less = std::min(left, right), more = std::max(left, right);
  if (less < options_.contrast) {
    const bool is_alone = more >= options_.contrast && less < kAlone * more;
    return is_alone ? Validity::view_lost : Validity::picture_lost;
  }
  try {
    if (are_swapped(frame, clock)) return Validity::views_swapped;
  } catch (const InputError&) {
    // Of another size than the calibration's, which is told elsewhere.
  }
  return Validity::too_few_points;
}

}  // namespace glisson::guidance
