// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "glisson/core/statistics.h"
#include "pixel_scale.h"

namespace glisson::guidance {
namespace {

/// Time over which motion is judged, whatever the frame rate: 0.4 s, a little less because video files round
/// their times.
constexpr double kSeconds = 0.38;
constexpr std::size_t kLeastFrames = 4, kMostFrames = 60;
constexpr std::size_t kLeastInGroup = 6;
constexpr int kGroups = 4;  ///< along each side of the picture
/// Frames from which the calibration's own offset of rows is learned.
constexpr int kFirstFrames = 5;
/// Pixels (pixel_scale()): the most that a calibration may leave, of the median and of the points' scatter
/// about it. What was there at first is taken off up to this only.
constexpr double kMostRows = 1.0, kMostScatter = 0.7;
constexpr double kUnknown = -1.0;
/// Places shared with the first ones from which growth is told; with fewer, the present ones follow on.
constexpr std::size_t kLeastPlaces = 30;
/// Metres: depth's error weighs too much in shorter distances.
constexpr double kLeastApart = 20e-3;
constexpr std::size_t kEveryPair = 3;  ///< the others say the same

/// Places of one group's points over frames: a row each point, a column each frame.
using Paths = Eigen::MatrixXd;

/// The motion that all points of a group share, over the motion of each on its own, both as variances over
/// the whole time. Speeds from frame to frame would not do: at the turn of a breath they are zero.
double common_motion(const Paths& paths) {
  const auto n = static_cast<double>(paths.rows()), k = static_cast<double>(paths.cols());
  const Paths from_own_middle = paths.colwise() - paths.rowwise().mean();
  const Eigen::RowVectorXd together = from_own_middle.colwise().mean();
  const Paths alone = from_own_middle.rowwise() - together;
  // What a corner's place is known to at best keeps a codec's perfect stillness from dividing by zero.
  const double noise = std::max(alone.squaredNorm() / ((n - 1.0) * (k - 1.0)), 1e-6);
  return n * together.squaredNorm() / (k - 1.0) / noise;
}

}  // namespace

double epipolar_offset(const StereoRig& rig, const Eigen::Vector2d& left, const Eigen::Vector2d& right) {
  const Eigen::Vector3d ray = rig.right_from_left.rotation * rig.left.ray(left);
  const Eigen::Vector3d normal = rig.right_from_left.translation.cross(ray);
  const Eigen::Vector3d seen = rig.right.ray(right);
  // In the normalised picture the line is normal . (x, y, 1) = 0.
  const double across = normal.head<2>().norm();
  return across > 0.0 ? rig.right.matrix(1, 1) * normal.dot(seen) / across : 0.0;
}

void MotionCheck::keep(Frame now) {
  clock_.tick(now.seconds);  // a source whose time stands, or that has none, must not escape
  now.seconds = clock_.now();
  frames_.push_back(std::move(now));
  const auto is_old = [this] { return frames_.front().seconds < frames_.back().seconds - kSeconds; };
  while (frames_.size() > kMostFrames || (frames_.size() > kLeastFrames && is_old())) frames_.pop_front();
}

bool MotionCheck::is_whole() const {
  if (frames_.size() < kLeastFrames) return false;
  const double one = frames_.back().seconds - frames_[frames_.size() - 2].seconds;
  return frames_.size() == kMostFrames || frames_.back().seconds - frames_.front().seconds > kSeconds - one;
}

void MotionCheck::push(const std::vector<FollowedPoint>& points, const StereoRig& rig, double seconds) {
  Pixels pixels;
  std::vector<double> offsets;
  for (const FollowedPoint& point : points) {
    offsets.push_back(epipolar_offset(rig, point.left, point.right));
    pixels[point.id] << point.left, point.right;
  }
  keep({seconds, std::move(pixels)});
  look_at_motion(rig);
  look_at_size(points);
  if (offsets.empty()) return;
  const double offset = upper_median(offsets);
  scale_ = pixel_scale(rig.right.width);
  if (rows_seen_ < kFirstFrames) {
    first_rows_ = (rows_seen_ * first_rows_ + offset) / (rows_seen_ + 1.0);
    const double scatter = kDeviationPerMad * median_absolute_deviation(offsets, offset);
    rows_scatter_ = std::min(scale_ * kMostScatter, std::max(rows_scatter_, scatter));
  }
  ++rows_seen_;
  rows_ = offset - std::clamp(first_rows_, -scale_ * kMostRows, scale_ * kMostRows);
}

void MotionCheck::look_at_size(const std::vector<FollowedPoint>& points) {
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> places;  // at first, now
  std::vector<double> ranges, growths;                              // growths: squared
  for (const FollowedPoint& point : points) {
    const auto first = first_places_.find(point.id);
    if (first == first_places_.end()) continue;
    places.emplace_back(first->second, point.p_in_camera);
    ranges.push_back(point.p_in_camera.norm());
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); j += kEveryPair) {
      const double at_first = (places[i].first - places[j].first).squaredNorm();
      const double now = (places[i].second - places[j].second).squaredNorm();
      if (at_first > kLeastApart * kLeastApart && now > 0.0) growths.push_back(now / at_first);
    }
  if (places.size() >= kLeastPlaces && growths.size() >= kLeastPlaces) {
    const double least = grown_before_ + 0.5 * std::log(lower_percentile(growths, 0.25)),
                 most = grown_before_ + 0.5 * std::log(lower_percentile(growths, 0.75));
    growth_ = least > 0.0 ? least : std::min(most, 0.0);
    depth_off_ = std::expm1(growth_) * upper_median(ranges);
    return;
  }
  if (points.size() < kLeastPlaces) return;
  grown_before_ = growth_;  // what three quarters say: where tissue is pulled, the median goes with it
  first_places_.clear();
  for (const FollowedPoint& point : points) first_places_[point.id] = point.p_in_camera;
}

void MotionCheck::look_at_motion(const StereoRig& rig) {
  motion_ = {kUnknown, kUnknown};
  if (!is_whole()) return;
  // Points that were followed all the time, by where they are now in the left view.
  std::map<int, std::vector<int>> groups;
  for (const auto& [id, place] : frames_.back().pixels) {
    const bool is_in_all = std::all_of(frames_.begin(), frames_.end(),
                                       [id = id](const Frame& frame) { return frame.pixels.contains(id); });
    if (!is_in_all) continue;
    const int column = std::clamp(static_cast<int>(kGroups * place.x() / rig.left.width), 0, kGroups - 1);
    const int row = std::clamp(static_cast<int>(kGroups * place.y() / rig.left.height), 0, kGroups - 1);
    groups[kGroups * row + column].push_back(id);
  }
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int known = 0;
  for (const auto& [group, ids] : groups) {
    if (ids.size() < kLeastInGroup) continue;
    ++known;
    std::array<Paths, 4> paths;  // left x and y, right x and y
    paths.fill(Paths(static_cast<Eigen::Index>(ids.size()), static_cast<Eigen::Index>(frames_.size())));
    for (std::size_t k = 0; k < frames_.size(); ++k)
      for (std::size_t i = 0; i < ids.size(); ++i) {
        const Eigen::Vector4d& pixels = frames_[k].pixels.at(ids[i]);
        for (std::size_t axis = 0; axis < 4; ++axis)
          paths[axis](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
              pixels[static_cast<Eigen::Index>(axis)];
      }
    sum[0] += 0.5 * (common_motion(paths[0]) + common_motion(paths[1]));
    sum[1] += 0.5 * (common_motion(paths[2]) + common_motion(paths[3]));
  }
  if (known > 0) motion_ = {sum[0] / known, sum[1] / known};
}

}  // namespace glisson::guidance
