// SPDX-License-Identifier: GPL-3.0-or-later
#include "star.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glisson::segmentation {
namespace {

using Vec = Eigen::Vector3d;

/// Of each ray, the evidence gathered up to a boundary after so many steps.
using Sums = std::vector<std::vector<float>>;

/// What speaks for a radius of half the diameter.
double prior(double radius_mm, double diameter_mm) {
  constexpr double kWeight = 2.0;
  const double z = (radius_mm - 0.5 * diameter_mm) / (Star::kDrawnShare * diameter_mm);
  return -kWeight * z * z;
}

Sums sums_from(const Field& field, const std::vector<float>& evidence, const Vec& middle,
               const StarOptions& options) {
  const auto count = static_cast<std::size_t>(options.reach_mm / Rays::kStep);
  Sums sums(Rays::kCount, std::vector<float>(count + 1, 0.0F));
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    double sum = 0.0, most = 0.0;
    for (std::size_t s = 0; s < count; ++s) {
      const Vec p = middle + ((static_cast<double>(s) + 0.5) * Rays::kStep) *
                                 rays().way(n).cwiseQuotient(field.spacing_mm);
      const bool seen = sum > most - options.lost && field.contains(p.array().round().matrix().cast<int>());
      sum += Rays::kStep * (seen ? trilinear(field, evidence, p) : options.against);
      most = std::max(most, sum);
      sums[n][s + 1] = static_cast<float>(sum);
    }
    if (options.diameter_mm > 0.0)
      for (std::size_t r = 0; r <= count; ++r)
        sums[n][r] += static_cast<float>(prior(Rays::kStep * static_cast<double>(r), options.diameter_mm));
  }
  return sums;
}

int best_of(const std::vector<float>& sums) {
  return std::max(1, static_cast<int>(std::max_element(sums.begin(), sums.end()) - sums.begin()));
}

/// Each ray by itself, then thrice the median of it and its neighbours.
std::vector<int> first_radii(const Sums& sums) {
  std::vector<int> radii(Rays::kCount);
  for (std::size_t n = 0; n < Rays::kCount; ++n) radii[n] = best_of(sums[n]);
  for (int pass = 0; pass < 3; ++pass) {
    const std::vector<int> before = radii;
    for (std::size_t n = 0; n < Rays::kCount; ++n) {
      std::array<int, Rays::kNeighbours + 1> around{};
      for (std::size_t m = 0; m < Rays::kNeighbours; ++m) around[m] = before[rays().near(n)[m]];
      around.back() = before[n];
      std::nth_element(around.begin(), around.begin() + around.size() / 2, around.end());
      radii[n] = around[around.size() / 2];
    }
  }
  return radii;
}

/// One sweep over all rays.
void settle(const Sums& sums, double weight, std::vector<int>& radii) {
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    double mean = 0.0;
    for (const std::size_t m : rays().near(n)) mean += static_cast<double>(radii[m]) / Rays::kNeighbours;
    double best = -1e30;
    for (std::size_t r = 1; r < sums[n].size(); ++r) {
      const double off = Rays::kStep * (static_cast<double>(r) - mean);
      const double score = sums[n][r] - weight * off * off;
      if (score > best) best = score, radii[n] = static_cast<int>(r);
    }
  }
}

std::vector<int> best_radii(const Sums& sums, double stiff, double soft) {
  constexpr double kSofter = 0.6;
  constexpr int kSweeps = 6;
  std::vector<int> radii = first_radii(sums);
  for (double weight = stiff; weight >= soft; weight *= kSofter)
    for (int sweep = 0; sweep < kSweeps; ++sweep) settle(sums, weight, radii);
  return radii;
}

/// From the middle, in mm.
Vec centroid_of(const Star& star) {
  Vec sum = Vec::Zero();
  double volume = 0.0;
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    const double r3 = std::pow(star.radius_mm(n), 3);
    sum += 0.75 * r3 * star.radius_mm(n) * rays().way(n);
    volume += r3;
  }
  return sum / volume;
}

}  // namespace

double trilinear(const Field& field, const std::vector<float>& values, const Vec& at) {
  const Eigen::Vector3i last = field.size - Eigen::Vector3i::Ones();
  const Vec x = at.cwiseMax(0.0).cwiseMin(last.cast<double>());
  const Eigen::Vector3i low = x.array().floor().matrix().cast<int>();
  const Vec t = x - low.cast<double>();
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3i step(corner & 1, (corner >> 1) & 1, corner >> 2);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) weight *= step[axis] != 0 ? t[axis] : 1.0 - t[axis];
    sum += weight * values[field.offset((low + step).cwiseMin(last))];
  }
  return sum;
}

Rays::Rays() : near_(kCount) {
  const double golden = M_PI * (3.0 - std::sqrt(5.0)), count = static_cast<double>(kCount);
  for (std::size_t n = 0; n < kCount; ++n) {
    const double z = 1.0 - (2.0 * static_cast<double>(n) + 1.0) / count, r = std::sqrt(1.0 - z * z);
    const double angle = golden * static_cast<double>(n);
    ways_.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  for (std::size_t n = 0; n < kCount; ++n) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t m = 0; m < kCount; ++m)
      if (m != n) order.emplace_back(-ways_[n].dot(ways_[m]), m);
    std::partial_sort(order.begin(), order.begin() + kNeighbours, order.end());
    for (std::size_t m = 0; m < kNeighbours; ++m) near_[n][m] = order[m].second;
  }
}

const Rays& rays() {
  static const Rays kRays;
  return kRays;
}

double Star::mean_radius_mm() const {
  double sum = 0.0;
  for (std::size_t n = 0; n < radii.size(); ++n) sum += radius_mm(n);
  return radii.empty() ? 0.0 : sum / static_cast<double>(radii.size());
}

double Star::radius_towards_mm(const Vec& way) const {
  std::size_t best = 0;
  for (std::size_t n = 1; n < Rays::kCount; ++n)
    if (rays().way(n).dot(way) > rays().way(best).dot(way)) best = n;
  return radius_mm(best);
}

Star grow_star(const Field& field, const std::vector<float>& evidence, Star from, const Vec& inside,
               int moves, const StarOptions& options) {
  constexpr double kSlack = 2.0;  // mm
  Vec middle = from.middle;
  for (int move = 0; move < moves; ++move) {
    // A click need not lie in the middle: before the first move the rays differ by as much as the body is
    // wide.
    const bool off_middle = from.radii.empty() && !(options.diameter_mm > 0.0);
    Star next{middle, best_radii(sums_from(field, evidence, middle, options),
                                 off_middle ? options.soft : options.stiff, options.soft)};
    const Vec to_inside = (inside - middle).cwiseProduct(field.spacing_mm);
    if (!from.radii.empty() && next.radius_towards_mm(to_inside) + kSlack < to_inside.norm()) break;
    from = std::move(next);
    middle += centroid_of(from).cwiseQuotient(field.spacing_mm);
  }
  return from;
}

double gathered(const Field& field, const std::vector<float>& evidence, const Star& star,
                const StarOptions& options) {
  const Sums sums = sums_from(field, evidence, star.middle, options);
  double sum = 0.0;
  for (std::size_t n = 0; n < Rays::kCount; ++n) sum += sums[n][static_cast<std::size_t>(star.radii[n])];
  return sum / static_cast<double>(Rays::kCount);
}

Field distance_to(const Star& star, const Field& field, double band_mm) {
  constexpr double kNear = 0.985;  // cosine to the rays that count: three or four of them
  const auto [shortest, longest] = std::minmax_element(star.radii.begin(), star.radii.end());
  double in = 0.0, out = 0.0;
  for (const double beyond : star.beyond_mm) in = std::min(in, beyond), out = std::max(out, beyond);
  const double low = Rays::kStep * *shortest + in - band_mm, high = Rays::kStep * *longest + out + band_mm;
  Field phi = field.filled(static_cast<float>(band_mm));
  std::size_t at = 0;
  for (int k = 0; k < field.size.z(); ++k)
    for (int j = 0; j < field.size.y(); ++j)
      for (int i = 0; i < field.size.x(); ++i, ++at) {
        const Vec d = (Vec(i, j, k) - star.middle).cwiseProduct(field.spacing_mm);
        const double far = d.norm();
        if (far > high) continue;
        double weights = 0.0, radius = 0.0;
        for (std::size_t n = 0; far > std::max(low, 1e-6) && n < Rays::kCount; ++n) {
          const double cosine = rays().way(n).dot(d) / far;
          if (cosine < kNear) continue;
          const double weight = (cosine - kNear) * (cosine - kNear);
          weights += weight;
          radius += weight * star.radius_mm(n);
        }
        phi.values[at] = static_cast<float>(
            weights > 0.0 ? std::clamp(far - radius / weights, -band_mm, band_mm) : -band_mm);
      }
  return phi;
}

}  // namespace glisson::segmentation
