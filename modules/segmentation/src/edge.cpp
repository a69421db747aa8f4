// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "glisson/core/statistics.h"

namespace glisson::segmentation {
namespace {

using Vec = Eigen::Vector3d;

constexpr int kIn = 4, kOut = 1, kSide = 4;  // steps: the moves, and what is looked at to either side
constexpr int kSeen = 2;                     // steps just outside in which a body must be able to end
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
      const bool outside = cell >= kIn + kSide && cell < kIn + kSide + kSeen;
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

/// A step between two levels, blurred: how much of it has been made in each cell, less the mean of that.
struct Step {
  double middle_mm = 0.0;  ///< off the ray's end
  double sigma_mm = 0.0;
  Profile share{};
  double spread = 0.0;  ///< sum of the squares
  double mean = 0.0;    ///< of the shares themselves
};

Step step_of(double middle_mm, double sigma_mm) {
  Step step{middle_mm, sigma_mm};
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const double x = Rays::kStep * (static_cast<double>(cell) - kIn - kSide + 0.5) - middle_mm;
    step.share[cell] = 0.5 * std::erfc(-x / (std::sqrt(2.0) * sigma_mm));
    step.mean += step.share[cell] / kCells;
  }
  for (double& share : step.share) share -= step.mean, step.spread += share * share;
  return step;
}

/// All steps within a boundary's reach.
std::vector<Step> steps_of(double least_sigma_mm, double most_sigma_mm) {
  constexpr double kFine = 0.125;  // mm
  std::vector<Step> steps;
  for (double sigma = least_sigma_mm; sigma <= most_sigma_mm; sigma += kFine)
    for (double middle = -Rays::kStep * kIn; middle <= Rays::kStep * kOut; middle += kFine)
      steps.push_back(step_of(middle, sigma));
  return steps;
}

struct Fitted {
  const Step* step;
  double rise;
};
/// The nearest one to a profile, by least squares over both levels.
Fitted fitted(const Profile& profile, const std::vector<Step>& steps) {
  Fitted best{nullptr, 0.0};
  double most = -1.0;
  for (const Step& step : steps) {
    double product = 0.0;
    for (std::size_t cell = 0; cell < kCells; ++cell) product += step.share[cell] * profile[cell];
    if (const double explained = product * product / step.spread; explained > most)
      most = explained, best = {&step, product / step.spread};
  }
  return best;
}

/// Where the steps are half way down, mm off each ray's end, and how wide they are.
struct HalfWay {
  std::vector<std::optional<double>> off_mm;  ///< none where the step is not like most
  double sigma_mm = 0.0;
};

/// Whether a step leads to the tissue around the body, and not to a rim of its own.
bool leads_to(double around, const Profile& profile, const Fitted& one) {
  constexpr double kMost = 0.15;  // of the rise
  double level = (1.0 - one.step->mean) * one.rise;
  for (const double value : profile) level += value / kCells;
  return std::abs(level - around) < kMost * std::abs(one.rise);
}

HalfWay half_way(const Rim& rim, const std::vector<Profile>& means, double around) {
  constexpr double kNarrowest = 0.5, kWidest = 4.0;  // mm
  constexpr double kLike = 0.3;                      // of the median rise
  std::vector<double> sigmas, rises;
  std::size_t leading = 0;
  const std::vector<Step> all = steps_of(kNarrowest, kWidest);
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    if (rim.fixed[n]) continue;
    const Fitted one = fitted(means[n], all);
    sigmas.push_back(one.step->sigma_mm);
    rises.push_back(one.rise);
    leading += leads_to(around, means[n], one);
  }
  HalfWay result{std::vector<std::optional<double>>(Rays::kCount), 0.0};
  if (2 * leading <= sigmas.size()) return result;
  result.sigma_mm = upper_median(sigmas);
  const double rise = upper_median(rises);
  const std::vector<Step> alike = steps_of(result.sigma_mm, result.sigma_mm);
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    if (rim.fixed[n]) continue;
    const Fitted one = fitted(means[n], alike);
    if (one.rise / rise > kLike) result.off_mm[n] = one.step->middle_mm;
  }
  return result;
}

/// How far the boundary goes from where the evidence has it towards half way. @pre the star is where the
/// evidence has it. @param before its radii when the rim was read, steps.
std::vector<double> towards_half_way(const HalfWay& half, const std::vector<int>& before, double blur_mm,
                                     const Star& star) {
  constexpr double kAbrupt = 1.45, kTissue = 1.75;  // of the blur's variance
  const double variance = half.sigma_mm * half.sigma_mm / (blur_mm * blur_mm);
  const double share = std::clamp((kTissue - variance) / (kTissue - kAbrupt), 0.0, 1.0);
  const auto end_of = [&](std::size_t n) -> std::optional<double> {
    if (!half.off_mm[n]) return {};
    const double radius = std::max(Rays::kStep, Rays::kStep * before[n] + *half.off_mm[n]);
    return radius + blur_mm * blur_mm / std::max(radius, 2.0 * blur_mm);
  };
  std::vector<double> beyond(Rays::kCount, 0.0);
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    const auto own = end_of(n);
    double sum = own.value_or(0.0), count = own ? 1.0 : 0.0;
    for (const std::size_t m : rays().near(n))
      if (const auto other = end_of(m)) sum += *other, count += 1.0;
    if (own) beyond[n] = share * (sum / count - star.radius_mm(n));
  }
  return beyond;
}

}  // namespace

void move_to_edge(const EdgeView& view, Star& star) {
  constexpr double kWeight = 0.4;  // 1 / mm^2
  constexpr int kSweeps = 12;
  const Rim rim = rim_of(view, star);
  std::vector<Profile> means;
  std::vector<Scores> scores;
  std::vector<int> moves;  // from 0: kIn steps inwards
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    means.push_back(pooled(rim, n));
    scores.push_back(scores_of(means[n], view));
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
  const std::vector<int> before = star.radii;
  for (std::size_t n = 0; n < Rays::kCount; ++n) star.radii[n] = std::max(1, before[n] + moves[n] - kIn);
  const HalfWay half = half_way(rim, means, view.around);
  star.beyond_mm = towards_half_way(half, before, view.blur_mm, star);
}

}  // namespace glisson::segmentation
