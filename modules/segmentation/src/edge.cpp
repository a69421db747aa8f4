// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge.h"

#include <algorithm>
#include <cmath>

namespace glisson::segmentation {
namespace {

using Vec = Eigen::Vector3d;

constexpr int kIn = 4, kOut = 1, kSide = 4;  // steps: the moves, and what is looked at to either side
constexpr int kMoves = kIn + kOut + 1, kCells = kIn + kOut + 2 * kSide;

/// Intensities between the steps from kIn + kSide within a ray's end to kOut + kSide beyond it.
using Profile = std::array<double, kCells>;

struct Rim {
  std::vector<Profile> profiles;
  std::vector<bool> fixed;
};

Rim rim_of(const EdgeView& view, const Star& star) {
  Rim rim{std::vector<Profile>(Rays::kCount), std::vector<bool>(Rays::kCount, false)};
  for (std::size_t n = 0; n < Rays::kCount; ++n)
    for (int cell = 0; cell < kCells; ++cell) {
      const double radius = star.radius_mm(n) + Rays::kStep * (cell - kIn - kSide + 0.5);
      const Vec p = star.middle + std::max(0.0, radius) * rays().way(n).cwiseQuotient(view.raw.spacing_mm);
      const Eigen::Vector3i v = p.array().round().matrix().cast<int>();
      const bool outside = cell >= kIn + kSide && cell < kIn + 2 * kSide;
      if (outside && (!view.raw.contains(v) || view.may[view.raw.offset(v)] == 0)) rim.fixed[n] = true;
      rim.profiles[n][static_cast<std::size_t>(cell)] = trilinear(view.raw, view.raw.values, p);
    }
  return rim;
}

/// The mean of a ray's profile and its neighbours', as far as they count.
Profile pooled(const Rim& rim, std::size_t ray) {
  Profile mean = rim.profiles[ray];
  double count = 1.0;
  for (const std::size_t m : rays().near(ray)) {
    if (rim.fixed[m]) continue;
    for (std::size_t cell = 0; cell < kCells; ++cell) mean[cell] += rim.profiles[m][cell];
    count += 1.0;
  }
  for (double& value : mean) value /= count;
  return mean;
}

using Scores = std::array<double, kMoves>;

Scores scores_of(const Profile& profile, const EdgeView& view) {
  Scores scores{};
  double sum = 0.0;
  for (int cell = kSide; cell < kSide + kMoves; ++cell) {
    scores[static_cast<std::size_t>(cell - kSide)] = sum;
    sum += Rays::kStep * view.evidence(profile[static_cast<std::size_t>(cell)]);
  }
  return scores;
}

}  // namespace

void move_to_edge(const EdgeView& view, Star& star) {
  constexpr double kWeight = 0.4;  // 1 / mm^2
  constexpr int kSweeps = 12;
  const Rim rim = rim_of(view, star);
  std::vector<Scores> scores;
  std::vector<int> moves;  // from 0: kIn steps inwards
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    scores.push_back(scores_of(pooled(rim, n), view));
    const auto best = std::max_element(scores[n].begin(), scores[n].end()) - scores[n].begin();
    moves.push_back(rim.fixed[n] ? kIn : static_cast<int>(best));
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t n = 0; n < Rays::kCount; ++n) {
      if (rim.fixed[n]) continue;
      double mean = 0.0;
      for (const std::size_t m : rays().near(n)) mean += static_cast<double>(moves[m]) / Rays::kNeighbours;
      double most = -1e30;
      for (int move = 0; move < kMoves; ++move) {
        const double off = Rays::kStep * (move - mean);
        const double score = scores[n][static_cast<std::size_t>(move)] - kWeight * off * off;
        if (score > most) most = score, moves[n] = move;
      }
    }
  for (std::size_t n = 0; n < Rays::kCount; ++n) star.radii[n] = std::max(1, star.radii[n] + moves[n] - kIn);
}

}  // namespace glisson::segmentation
