// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <deque>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "glisson/stereo/faults.h"
#include "interlace.h"
#include "picture_cv.h"
#include "view_state.h"

namespace glisson::stereo {
namespace {

constexpr int kWidth = 96;
// Grey levels of thumbnails. A sensor's noise of one level leaves some 0.1 there.
constexpr double kMoves = 0.2;
constexpr double kFrozenSeconds = 0.2 - 1e-3;  // containers round times to milliseconds

bool without_content(const cv::Mat& view) {
  constexpr double kDark = 14.0, kBrightest = 40.0, kFlat = 2.0;
  cv::Scalar mean, deviation;
  cv::meanStdDev(view, mean, deviation);
  double brightest = 0.0;
  cv::minMaxLoc(view, nullptr, &brightest);
  return (mean[0] < kDark && brightest < kBrightest) || deviation[0] < kFlat;
}

/// Whether two views are one picture, coded twice: they differ by less than a shift of a quarter of a
/// thumbnail's pixel would make, 1/384 of the width, and by less than coarse coding leaves (mp4v at one bit a
/// pixel: 0.75 grey levels). Two cameras differ more: a baseline of 4 mm shifts by 1/50 of the width and more
/// up to 20 cm, converging cameras by 1/60 between 8 and 12 cm.
bool same_view(const cv::Mat& left, const cv::Mat& right) {
  constexpr double kShift = 0.25, kCodingNoise = 1.0;
  const double a_pixel = difference(left.colRange(1, left.cols), left.colRange(0, left.cols - 1));
  return difference(left, right) < std::min(kShift * a_pixel, kCodingNoise);
}

/// Tells from the changes of one view, frame to frame, whether it stands still. Noise and motion change every
/// frame. A codec swallows part of that, and changes even a picture that came twice. So a view stands when it
/// changes far less than in the quietest of its last few frames and less than coded noise. The median of
/// those would not do: tissue and camera come to rest within some frames, and key frames change everything.
/// Where the codec swallows nearly all change, nothing is said.
class ViewMotion {
 public:
  static constexpr double kStill = 0.3;
  // Grey levels, means over all pixels.
  static constexpr double kCoded = 0.3;      ///< what a sensor's noise of 2 leaves once coded
  static constexpr double kSwallowed = 0.1;  ///< each tenth pixel by one level

  /// @param change mean absolute difference of all pixels to the frame before, grey levels
  bool stands(double change) {
    if (change <= limit()) {
      ++run_;
      pending_.clear();
      return true;
    }
    // A key frame codes a standing picture anew, and the frames after it mend that. Such changes are motion
    // only if they go on.
    if (run_ < kFreeze) run_ = 0;
    const std::size_t doubtful = run_ >= kFreeze ? kMending : change < kDoubtful * quietest() ? 1 : 0;
    pending_.push_back(change);
    if (pending_.size() <= doubtful) return false;
    run_ = 0;
    for (const double moved : pending_) changes_.push_back(moved);
    pending_.clear();
    while (changes_.size() > kRemembered) changes_.pop_front();
    return false;
  }
  /// Surely in motion: it does not stand, and its changes are not those of a key frame either.
  bool moves() const { return run_ == 0; }

 private:
  static constexpr std::size_t kRemembered = 4;
  static constexpr std::size_t kMending = 3;
  static constexpr int kFreeze = 3;
  static constexpr double kDoubtful = 0.5;

  double limit() const {
    if (changes_.size() < kRemembered) return 0.0;  // too early: only what is equal to the last bit
    return quietest() > kSwallowed ? kStill * std::min(quietest(), kCoded) : -1.0;
  }
  double quietest() const {
    return changes_.empty() ? 0.0 : *std::min_element(changes_.begin(), changes_.end());
  }

  std::deque<double> changes_;  ///< the last ones in motion
  std::deque<double> pending_;  ///< not known yet to be motion
  int run_ = 0;                 ///< frames that it stands
};

/// What is remembered of a frame.
struct Seen {
  cv::Mat left, right;  ///< thumbnails
  int index = 0;
  double seconds = 0.0;
};

double between(const Seen& a, const Seen& b) {
  return difference(a.left, b.left) + difference(a.right, b.right);
}

}  // namespace

cv::Mat thumbnail(const Picture& picture) { return thumbnail(grey(picture)); }

cv::Mat thumbnail(const cv::Mat& grey) {
  cv::Mat small, result;
  const int height = std::max(1, kWidth * grey.rows / std::max(1, grey.cols));
  cv::resize(grey, small, cv::Size(kWidth, height), 0.0, 0.0, cv::INTER_AREA);
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
  if (same_view(left, right)) return {Fault::one_view};
  return {};
}

struct SequenceCheck::Impl {
  std::deque<Seen> seen;      ///< the last three that were sound and new, newest last
  double still_since = -1.0;  ///< when both views stopped; negative: they move
  cv::Mat left, right;        ///< the last sound frame, grey, all pixels
  double seconds = 0.0;       ///< its time
  ViewMotion left_motion, right_motion;
  Interlace left_rows, right_rows;
  bool interlace_told = false;

  /// Whether the last two frames came in the wrong order: the last one fits between the two before it, and
  /// the new frame continues the last but one.
  bool exchanged(const Seen& now) const {
    if (seen.size() < 3) return false;
    const Seen &a = seen[0], &b = seen[1], &c = seen[2];
    const double ab = between(a, b), ac = between(a, c), bn = between(b, now), cn = between(c, now);
    return ac < 0.8 * ab && bn < 0.8 * cn && ab > 2.0 * kMoves && cn > 2.0 * kMoves;
  }

  /// Whether each view continues the other one's last picture. Swapped frames are remembered the right way
  /// round, so that this stays true as long as they are swapped.
  bool crossed(const Seen& now) const {
    if (seen.empty()) return false;
    const Seen& last = seen.back();
    const double straight = between(last, now);
    const double across = difference(last.left, now.right) + difference(last.right, now.left);
    return across < 0.5 * straight && straight > 2.0 * kMoves;
  }

  /// What does not go on, and remembers the frame.
  std::optional<Fault> still(const cv::Mat& now_left, const cv::Mat& now_right, double now) {
    const cv::Mat before_left = left, before_right = right;
    const double before = seconds;
    left = now_left;
    right = now_right;
    seconds = now;
    if (before_left.empty()) return std::nullopt;
    const double left_change = difference(before_left, left), right_change = difference(before_right, right);
    const bool left_stands = left_motion.stands(left_change),
               right_stands = right_motion.stands(right_change);
    if (left_motion.moves() || right_motion.moves()) still_since = -1.0;
    if (left_stands && right_stands) {
      if (still_since < 0.0) still_since = before;
      return now - still_since >= kFrozenSeconds ? Fault::frozen : Fault::duplicated;
    }
    if (left_stands && far_below(left_change, right_change)) return Fault::left_frozen;
    if (right_stands && far_below(right_change, left_change)) return Fault::right_frozen;
    return std::nullopt;
  }

  /// Whether it has become known just now, and has not been told.
  bool found_interlaced() {
    const bool left_is = left_rows.push(left), right_is = right_rows.push(right);
    return (left_is || right_is) && !std::exchange(interlace_told, true);
  }

  /// Whether one view stands while the other goes on.
  static bool far_below(double standing, double other) {
    return other > ViewMotion::kSwallowed && standing < ViewMotion::kStill * other;
  }
};

SequenceCheck::SequenceCheck() : impl_(std::make_unique<Impl>()) {}
SequenceCheck::~SequenceCheck() = default;

std::vector<FrameFault> SequenceCheck::push(const StereoFrame& frame) {
  std::vector<FrameFault> found;
  const auto say = [&](Fault fault, int index) { found.push_back({index, fault}); };
  cv::Mat left = grey(frame.left), right = grey(frame.right);
  Seen now{thumbnail(left), thumbnail(right), frame.index, frame.seconds};
  for (const Fault fault : faults_of_views(now.left, now.right)) say(fault, frame.index);
  if (!found.empty()) return found;
  auto& seen = impl_->seen;
  if (impl_->crossed(now)) {
    say(Fault::swapped, frame.index);
    std::swap(now.left, now.right);
    std::swap(left, right);
  }
  const std::optional<Fault> still = impl_->still(left, right, frame.seconds);
  if (still) say(*still, frame.index);
  if (still == Fault::duplicated || still == Fault::frozen) return found;  // nothing new to remember
  if (impl_->found_interlaced()) say(Fault::interlaced, frame.index);
  if (impl_->exchanged(now)) {
    say(Fault::out_of_order, seen.back().index);
    std::swap(seen[1], seen[2]);  // as they should have come
  }
  seen.push_back(std::move(now));
  if (seen.size() > 3) seen.pop_front();
  return found;
}

}  // namespace glisson::stereo
