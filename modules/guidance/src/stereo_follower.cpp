// SPDX-License-Identifier: GPL-3.0-or-later
#include "stereo_follower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <thread>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "picture_view.h"
#include "triangulate.h"

namespace glisson::guidance {
namespace {

/// Grey levels of the camera from which a pixel is a highlight: it belongs to the lamp, not to the tissue.
constexpr int kHighlight = 245;

/// Lucas-Kanade's least eigenvalue, thousandths of squared slopes: a tenth of a grey level a pixel. Corners
/// were chosen by the noise; this only keeps it from dividing by nothing.
constexpr double kFlattest = 1e-5;

struct View {
  cv::Mat raw, grey;    ///< what the camera gave; multiplied by the gain, within its limits
  double level = 1.0;   ///< mean of `raw`
  double wanted = 1.0;  ///< gain that brings `raw` to the level at the start
  std::vector<cv::Mat> pyramid;
};

void to_grey(const Picture& picture, const Camera& camera, const char* name, cv::Mat& grey) {
  require_view(picture, camera, name);
  if (picture.channels == 1)
    view_of(picture).copyTo(grey);
  else
    cv::cvtColor(view_of(picture), grey, cv::COLOR_BGR2GRAY);
}

/// The gain that follows `before` where the mean level changes by this factor. A sudden change is of the
/// light (lamp, exposure) and is made up for: Lucas-Kanade would find nothing. A slow change is left alone:
/// it may be what is seen, and would be taken for motion. A gain goes back to one, because a brightened
/// picture has no texture where it is full: as fast as the light comes back, and slowly where it does not.
/// @return without the limits of what is applied, so that two changes and back end where they began.
double next_gain(double before, double change) {
  constexpr double kSudden = 0.08, kBack = 0.01;  // a frame; kBack is far below what is left alone
  if (std::abs(change - 1.0) > kSudden) return before / change;
  if (before > 1.0) return std::max(1.0, before / std::max(change, 1.0 + kBack));
  return std::min(1.0, before / std::min(change, 1.0 - kBack));
}

/// Into buffers that are used again: fresh ones would cost milliseconds of page faults a frame.
/// @param before the view that is followed from, to whose level the new one is brought; null: none.
void make_view(const Picture& picture, const Camera& camera, const char* name, const FollowerOptions& options,
               const View* before, View& view) {
  constexpr double kMostGain = 2.0;
  to_grey(picture, camera, name, view.raw);
  view.level = std::max(1.0, cv::mean(view.raw)[0]);
  view.wanted = before != nullptr ? next_gain(before->wanted, view.level / before->level) : 1.0;
  view.raw.convertTo(view.grey, -1, std::clamp(view.wanted, 1.0 / kMostGain, kMostGain));
  cv::buildOpticalFlowPyramid(view.grey, view.pyramid, cv::Size(options.window_px, options.window_px),
                              options.levels - 1, true);
}

/// How many grey levels of a view lie up to each one, as shares.
std::array<double, 256> shares_up_to(const cv::Mat& grey) {
  std::array<double, 256> shares{};
  for (int y = 0; y < grey.rows; ++y)
    for (const std::uint8_t* at = grey.ptr(y); at != grey.ptr(y) + grey.cols; ++at) shares[*at] += 1.0;
  double sum = 0.0;
  for (double& share : shares) share = (sum += share) / static_cast<double>(grey.total());
  return shares;
}

/// `view` with the grey levels of `wanted`, as far as a rising curve brings them there: what two cameras make
/// of the same light differs by one (gain, gamma, black level). Both see nearly the same, so their histograms
/// tell it. Views that hardly differ are left alone.
View at_levels_of(const View& wanted, const View& view, const FollowerOptions& options) {
  constexpr double kAlike = 0.08;
  const std::array<double, 256> from = shares_up_to(view.grey), to = shares_up_to(wanted.grey);
  cv::Mat curve(1, 256, CV_8U);
  double apart = 0.0, sum = 0.0;
  for (int level = 0, other = 0; level < 256; ++level) {
    const auto i = static_cast<std::size_t>(level);
    const double share = from[i] - (level > 0 ? from[i - 1] : 0.0), middle = from[i] - 0.5 * share;
    while (other < 255 && to[static_cast<std::size_t>(other)] < middle) ++other;
    curve.at<std::uint8_t>(level) = static_cast<std::uint8_t>(other);
    apart += share * std::abs(other - level);
    sum += share * std::max(other, level);
  }
  if (apart <= kAlike * sum) return view;
  View result;  // of its own: a copy would share the other's buffers
  cv::LUT(view.grey, curve, result.grey);
  cv::buildOpticalFlowPyramid(result.grey, result.pyramid, cv::Size(options.window_px, options.window_px),
                              options.levels - 1, true);
  return result;
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
                           stop, guessed ? cv::OPTFLOW_USE_INITIAL_FLOW : 0, kFlattest);
  cv::calcOpticalFlowPyrLK(next.pyramid, from.pyramid, to, returned, back, error, window, options.levels - 1,
                           stop, cv::OPTFLOW_USE_INITIAL_FLOW, kFlattest);
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

bool is_seen(const Camera& camera, const cv::Mat& inside, const Eigen::Vector2d& at) {
  return camera.sees(at) &&
         (inside.empty() || inside.at<std::uint8_t>(static_cast<int>(std::lround(at.y())),
                                                    static_cast<int>(std::lround(at.x()))) != 0);
}

/// Both cameras' work at once: `one_side(is_left)`. @throws what either throws.
template <class OneSide>
void on_both_sides(const OneSide& one_side) {
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

/// Standard deviation of a picture's noise where `allowed` (half the size) is set, grey levels, by
/// Immerkaer's mask (1996), which cancels slopes. From the lower quartile, in which texture weighs little; at
/// least what rounding to whole grey levels makes.
double noise_of(const cv::Mat& grey, const cv::Mat& allowed) {
  constexpr double kRounding = 0.29, kGain = 6.0, kQuartile = 0.3186;
  const cv::Mat mask = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::Mat left;
  cv::filter2D(grey, left, CV_16S, mask);
  std::vector<int> sizes;
  for (int y = 0; y < allowed.rows; ++y)
    for (int x = 0; x < allowed.cols; ++x)
      if (allowed.at<std::uint8_t>(y, x) != 0) sizes.push_back(std::abs(left.at<std::int16_t>(2 * y, 2 * x)));
  if (sizes.empty()) return kRounding;
  return std::max(kRounding, lower_percentile(std::move(sizes), 0.25) / (kQuartile * kGain));
}

/// Corners that can be found again within half a pixel of the whole picture in spite of noise: Lucas-Kanade's
/// squared error is 2 s^2 / (sum of squared slopes), s the noise. A limit relative to the strongest corner
/// would not do: beads, clips and the rims of highlights are far stronger than plain tissue.
/// @param half the picture at half its size. @return at most `most`, strongest first, in `half`.
std::vector<cv::Point2f> corners_of(const cv::Mat& whole, const cv::Mat& half, const cv::Mat& allowed,
                                    int most, double spacing) {
  constexpr int kBlock = 5;
  constexpr double kWithin = 0.25;                      // pixels of `half`
  const double noise = 0.5 * noise_of(whole, allowed);  // of four pixels' mean
  // OpenCV gives the least eigenvalue of slopes that are twice as large, over block and grey levels.
  const double scale = 2.0 / (kBlock * 255.0);
  const double least = 2.0 * noise * noise / (kWithin * kWithin) * scale * scale;
  cv::Mat strength;
  cv::cornerMinEigenVal(half, strength, kBlock);
  double strongest = 0.0;
  cv::minMaxLoc(strength, nullptr, &strongest, nullptr, nullptr, allowed);
  std::vector<cv::Point2f> corners;
  if (strongest > least)
    cv::goodFeaturesToTrack(half, corners, most, least / strongest, spacing, allowed, kBlock);
  return corners;
}

}  // namespace

struct StereoFollower::Images {
  View left, right, left_before, right_before;
  cv::Mat tissue, inside_left, inside_right;  ///< empty: everywhere
};

StereoFollower::StereoFollower(const StereoRig& rig, const FollowerOptions& options)
    : rig_(rig), options_(options), images_(std::make_unique<Images>()) {}

StereoFollower::~StereoFollower() = default;

void StereoFollower::begin(const StereoFrame& first, const SeenParts& parts) {
  make_view(first.left, rig_.left, "left view", options_, nullptr, images_->left);
  make_view(first.right, rig_.right, "right view", options_, nullptr, images_->right);
  for (const auto& [part, mat] : {std::pair{&parts.tissue, &images_->tissue},
                                  {&parts.left, &images_->inside_left},
                                  {&parts.right, &images_->inside_right}})
    *mat = part->empty() ? cv::Mat() : view_of(*part).clone();
  points_.clear();
  before_.clear();
}

StereoFollower::Counts StereoFollower::follow(const StereoFrame& frame) {
  before_ = points_;
  std::swap(images_->left_before, images_->left);
  std::swap(images_->right_before, images_->right);
  try {
    return follow_from_before(frame);
  } catch (...) {
    forget_last();
    throw;
  }
}

StereoFollower::Counts StereoFollower::follow_from_before(const StereoFrame& frame) {
  std::vector<cv::Point2f> left, right;
  std::vector<char> good_left, good_right;
  on_both_sides([&](bool is_left) {
    View& now = is_left ? images_->left : images_->right;
    make_view(is_left ? frame.left : frame.right, is_left ? rig_.left : rig_.right,
              is_left ? "left view" : "right view", options_,
              is_left ? &images_->left_before : &images_->right_before, now);
    auto& to = is_left ? left : right;
    (is_left ? good_left : good_right) =
        follow_both_ways(is_left ? images_->left_before : images_->right_before, now,
                         pixels(points_, is_left), to, false, options_);
  });
  Counts counts;
  std::vector<FollowedPoint> kept;
  kept.reserve(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    counts.left += good_left[i];
    counts.right += good_right[i];
    if (good_left[i] == 0 || good_right[i] == 0) continue;
    if (const auto point = passed(points_[i], pixel(left[i]), pixel(right[i]))) kept.push_back(*point);
  }
  points_ = std::move(kept);
  return counts;
}

std::vector<std::optional<FollowedPoint>> StereoFollower::carried(
    const std::vector<FollowedPoint>& points) const {
  std::vector<std::optional<FollowedPoint>> result(points.size());
  if (points.empty()) return result;
  std::vector<cv::Point2f> left, right;
  std::vector<char> good_left, good_right;
  on_both_sides([&](bool is_left) {
    (is_left ? good_left : good_right) = follow_both_ways(
        is_left ? images_->left_before : images_->right_before, is_left ? images_->left : images_->right,
        pixels(points, is_left), is_left ? left : right, false, options_);
  });
  for (std::size_t i = 0; i < points.size(); ++i)
    if (good_left[i] != 0 && good_right[i] != 0)
      result[i] = passed(points[i], pixel(left[i]), pixel(right[i]));
  return result;
}

std::optional<FollowedPoint> StereoFollower::passed(const FollowedPoint& point, const Eigen::Vector2d& left,
                                                    const Eigen::Vector2d& right) const {
  FollowedPoint result = point;
  result.left = left;
  result.right = right;
  if (!is_seen_by_both(result) || !triangulate_into(result)) return std::nullopt;
  return result;
}

bool StereoFollower::is_seen_by_both(const FollowedPoint& point) const {
  return is_seen(rig_.left, images_->inside_left, point.left) &&
         is_seen(rig_.right, images_->inside_right, point.right);
}

bool StereoFollower::triangulate_into(FollowedPoint& point) const {
  const Triangulated in_space = triangulate(rig_, point.left, point.right);
  if (!in_space.good || in_space.epipolar_px > options_.epipolar_px) return false;
  point.p_in_camera = in_space.p;
  point.information = in_space.information;
  return true;
}

bool StereoFollower::put(std::size_t index, const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
  FollowedPoint point = points_[index];
  point.left = left;
  point.right = right;
  if (!triangulate_into(point)) return false;
  points_[index] = point;
  return true;
}

bool StereoFollower::add(int id, const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
  FollowedPoint point;
  point.id = id;
  const auto passing = passed(point, left, right);
  if (passing) points_.push_back(*passing);
  return passing.has_value();
}

const cv::Mat& StereoFollower::grey(bool left) const {
  return left ? images_->left.grey : images_->right.grey;
}

double StereoFollower::spacing() const {
  return 0.4 * std::sqrt(static_cast<double>(images_->left.grey.total()) / options_.points);
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
  std::vector<FollowedPoint> found = find(expected, wanted, points_, cv::Mat());
  for (FollowedPoint& point : found) {
    point.id = next_id_++;
    points_.push_back(point);
  }
  return static_cast<int>(found.size());
}

std::vector<FollowedPoint> StereoFollower::find(const Expected& expected, int wanted,
                                                const std::vector<FollowedPoint>& others,
                                                const cv::Mat& where) const {
  std::vector<FollowedPoint> found;
  if (wanted <= 0) return found;
  const View& left = images_->left;
  // Corners are looked for at half the size: a quarter of the time, and Lucas-Kanade needs no better place.
  cv::Mat half, raw, allowed;
  cv::resize(left.grey, half, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
  cv::resize(left.raw, raw, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
  cv::compare(raw, kHighlight, allowed, cv::CMP_LT);
  cv::erode(allowed, allowed, cv::Mat(), cv::Point(-1, -1), 3);
  if (!images_->tissue.empty()) {
    cv::Mat tissue;
    cv::resize(images_->tissue, tissue, half.size(), 0, 0, cv::INTER_NEAREST);
    allowed &= tissue > 0;
  }
  if (!where.empty()) allowed &= where > 0;
  const double spacing = this->spacing();
  for (const FollowedPoint& point : others)
    cv::circle(allowed, cv::Point(static_cast<int>(point.left.x() / 2), static_cast<int>(point.left.y() / 2)),
               static_cast<int>(spacing / 2), cv::Scalar(0), cv::FILLED);
  const std::vector<cv::Point2f> corners = corners_of(left.grey, half, allowed, 3 * wanted, spacing / 2);

  std::vector<cv::Point2f> start, guess;
  for (const cv::Point2f& corner : corners) {
    const Eigen::Vector2d at(2.0 * corner.x + 0.5, 2.0 * corner.y + 0.5);
    const auto p = expected(at);
    if (!p) continue;
    const Eigen::Vector3d in_right = rig_.right_from_left.rotation * *p + rig_.right_from_left.translation;
    if (in_right.z() <= 0.0) continue;
    const Eigen::Vector2d there = rig_.right.project(in_right);
    if (!is_seen(rig_.right, images_->inside_right, there)) continue;
    start.emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()));
    guess.emplace_back(static_cast<float>(there.x()), static_cast<float>(there.y()));
  }
  const View right = start.empty() ? View() : at_levels_of(left, images_->right, options_);
  const std::vector<char> good = follow_both_ways(left, right, start, guess, true, options_);
  for (std::size_t i = 0; i < start.size() && static_cast<int>(found.size()) < wanted; ++i) {
    if (good[i] == 0) continue;
    FollowedPoint point;
    point.left = pixel(start[i]);
    point.right = pixel(guess[i]);
    if (triangulate_into(point)) found.push_back(point);
  }
  return found;
}

}  // namespace glisson::guidance
