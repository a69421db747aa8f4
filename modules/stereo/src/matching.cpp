// SPDX-License-Identifier: GPL-3.0-or-later
#include "matching.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "glisson/core/statistics.h"

namespace glisson::stereo {
namespace {

float squared_distance(const Keypoint& a, const Keypoint& b, std::size_t length) {
  float sum = 0.0F;
  for (std::size_t k = 0; k < length; ++k) {
    const float difference = a.descriptor[k] - b.descriptor[k];
    sum += difference * difference;
  }
  return sum;
}

struct Best {
  int index = -1;
  float first = std::numeric_limits<float>::max(), second = std::numeric_limits<float>::max();
};

/// For every keypoint of `from` the best of `to` in its band of rows.
std::vector<Best> best_in_band(const Rectified& from, const Rectified& to, double rows) {
  std::vector<int> order(to.positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto row = [&](int i) { return to.positions[static_cast<std::size_t>(i)].y(); };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return row(a) != row(b) ? row(a) < row(b) : a < b; });
  // A blob is found at several scales in nearly one place: the second best must be another place.
  constexpr double kSamePlace = 4.0, kScaleStep = 1.6;
  const auto length = static_cast<std::size_t>(from.length);
  std::vector<Best> bests(from.positions.size());
  for (std::size_t i = 0; i < from.positions.size(); ++i) {
    const Eigen::Vector2d& p = from.positions[i];
    Best& best = bests[i];
    Eigen::Vector2d place(-1e9, -1e9);
    auto it = std::lower_bound(order.begin(), order.end(), p.y() - rows,
                               [&](int j, double y) { return row(j) < y; });
    for (; it != order.end() && row(*it) <= p.y() + rows; ++it) {
      const auto j = static_cast<std::size_t>(*it);
      const double scales = to.keypoints[j].scale / from.keypoints[i].scale;
      if (to.keypoints[j].bright != from.keypoints[i].bright || scales > kScaleStep ||
          scales < 1.0 / kScaleStep)
        continue;
      const float distance = squared_distance(from.keypoints[i], to.keypoints[j], length);
      const bool same_place = (to.positions[j] - place).squaredNorm() < kSamePlace * kSamePlace;
      if (distance < best.first) {
        if (!same_place) best.second = best.first;
        best.first = distance;
        best.index = *it;
        place = to.positions[j];
      } else if (distance < best.second && !same_place) {
        best.second = distance;
      }
    }
  }
  return bests;
}

}  // namespace

Rectified rectify(const Rectification& rectification, Side side, std::vector<Keypoint> keypoints,
                  int length) {
  Rectified result;
  result.length = length;
  for (Keypoint& keypoint : keypoints)
    if (const auto position = rectification.rectify(side, keypoint.pixel)) {
      result.positions.push_back(*position);
      result.keypoints.push_back(std::move(keypoint));
    }
  return result;
}

std::vector<Match> match(const Rectified& left, const Rectified& right, const MatchLimits& limits) {
  const std::vector<Best> forward = best_in_band(left, right, limits.rows);
  const std::vector<Best> backward = best_in_band(right, left, limits.rows);
  const auto ratio = static_cast<float>(limits.ratio * limits.ratio);
  std::vector<Match> matches;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    const Best& best = forward[i];
    if (best.index < 0 || best.first > ratio * best.second) continue;
    const auto j = static_cast<std::size_t>(best.index);
    if (backward[j].index != static_cast<int>(i)) continue;
    matches.push_back({left.positions[i], right.positions[j]});
  }
  return matches;
}

Fit fit_of(const Rectification& rectification, const std::vector<Match>& matches, const MatchLimits& limits) {
  std::vector<double> rows;
  for (const Match& m : matches) {
    const double d = rectification.disparity(m.left, m.right);
    if (d >= limits.least_disparity && d <= limits.largest_disparity)
      rows.push_back(std::abs(m.left.y() - m.right.y()));
  }
  Fit fit;
  fit.plausible = static_cast<int>(rows.size());
  if (rows.empty()) return fit;
  fit.rows = upper_median(std::move(rows));
  return fit;
}

}  // namespace glisson::stereo
