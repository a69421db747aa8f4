// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "glisson/core/statistics.h"

namespace glisson::guidance {
namespace {

constexpr std::size_t kFrames = 12;  ///< over which motion is judged: 0.4 s at 30 a second
constexpr std::size_t kLeastInGroup = 6;
constexpr int kGroups = 4;  ///< along each side of the picture
/// Frames from which the calibration's own offset of rows is learned.
constexpr int kFirstFrames = 5;
constexpr double kUnknown = -1.0;

/// Motion of one frame: per group of the picture the squared mean of the points' ways over its expected
/// variance, which their scatter in the group tells; the mean over groups and both axes.
double squared_motion(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& place_and_way,
                      const Camera& camera) {
  std::map<int, std::vector<Eigen::Vector2d>> groups;
  for (const auto& [place, way] : place_and_way) {
    const int column = std::clamp(static_cast<int>(kGroups * place.x() / camera.width), 0, kGroups - 1);
    const int row = std::clamp(static_cast<int>(kGroups * place.y() / camera.height), 0, kGroups - 1);
    groups[kGroups * row + column].push_back(way);
  }
  std::vector<double> ratios;
  for (const auto& [group, ways] : groups) {
    if (ways.size() < kLeastInGroup) continue;
    const auto n = static_cast<double>(ways.size());
    for (int axis = 0; axis < 2; ++axis) {
      double sum = 0.0, squares = 0.0;
      for (const Eigen::Vector2d& way : ways) sum += way[axis];
      for (const Eigen::Vector2d& way : ways) squares += std::pow(way[axis] - sum / n, 2);
      // What a corner's place is known to at best keeps a codec's perfect stillness from dividing by zero.
      const double variance = std::max(squares / (n - 1.0), 1e-6) / n;
      ratios.push_back(std::pow(sum / n, 2) / variance);
    }
  }
  if (ratios.empty()) return kUnknown;
  double sum = 0.0;
  for (const double ratio : ratios) sum += ratio;
  return sum / static_cast<double>(ratios.size());
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

void MotionCheck::push(const std::vector<FollowedPoint>& before, const std::vector<FollowedPoint>& now,
                       const StereoRig& rig) {
  std::unordered_map<int, const FollowedPoint*> earlier;
  for (const FollowedPoint& point : before) earlier[point.id] = &point;
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> left, right;
  std::vector<double> offsets;
  for (const FollowedPoint& point : now) {
    offsets.push_back(epipolar_offset(rig, point.left, point.right));
    const auto found = earlier.find(point.id);
    if (found == earlier.end()) continue;
    left.emplace_back(point.left, point.left - found->second->left);
    right.emplace_back(point.right, point.right - found->second->right);
  }
  Frame frame;
  frame.left = squared_motion(left, rig.left);
  frame.right = squared_motion(right, rig.right);
  frame.known = frame.left >= 0.0 && frame.right >= 0.0;
  frames_.push_back(frame);
  if (frames_.size() > kFrames) frames_.pop_front();
  if (offsets.empty()) return;
  const double offset = upper_median(offsets);
  if (rows_seen_ < kFirstFrames) {
    first_rows_ = (rows_seen_ * first_rows_ + offset) / (rows_seen_ + 1.0);
    rows_scatter_ = std::max(rows_scatter_, kDeviationPerMad * median_absolute_deviation(offsets, offset));
  }
  ++rows_seen_;
  rows_ = offset - first_rows_;
}

double MotionCheck::motion(bool left) const {
  if (frames_.size() < kFrames) return kUnknown;
  double sum = 0.0;
  int known = 0;
  for (const Frame& frame : frames_) {
    if (!frame.known) continue;
    sum += left ? frame.left : frame.right;
    ++known;
  }
  return known * 2 < static_cast<int>(kFrames) ? kUnknown : sum / known;
}

}  // namespace glisson::guidance
