// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "glisson/core/statistics.h"

namespace glisson::stereo {
namespace {

double tukey(double x) {
  const double t = 1.0 - x * x;
  return std::abs(x) < 1.0 ? t * t : 0.0;
}

/// Robust plane through (x, y, value); @return its value at the origin and the residuals' deviation.
std::pair<double, double> plane_at_origin(const std::vector<Eigen::Vector3d>& samples) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(samples.size()));
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  double deviation = 0.0;
  for (int pass = 0; pass < 5; ++pass) {
    Eigen::Matrix3d normal = Eigen::Vector3d(1e-6, 1e-3, 1e-3).asDiagonal();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const Eigen::Vector3d row(1.0, samples[k].x(), samples[k].y());
      normal += weights[static_cast<Eigen::Index>(k)] * row * row.transpose();
      right += weights[static_cast<Eigen::Index>(k)] * samples[k].z() * row;
    }
    if (pass == 0) {  // the median first: least squares would follow a gross outlier
      std::vector<double> values;
      values.reserve(samples.size());
      for (const auto& s : samples) values.push_back(s.z());
      plane = Eigen::Vector3d(upper_median(std::move(values)), 0.0, 0.0);
    } else {
      plane = normal.ldlt().solve(right);
    }
    std::vector<double> residuals;
    residuals.reserve(samples.size());
    for (const auto& s : samples)
      residuals.push_back(std::abs(s.z() - plane.dot(Eigen::Vector3d(1.0, s.x(), s.y()))));
    deviation = kDeviationPerMad * upper_median(residuals);
    for (std::size_t k = 0; k < samples.size(); ++k)
      weights[static_cast<Eigen::Index>(k)] = tukey(residuals[k] / (4.7 * std::max(deviation, 0.1)));
  }
  return {plane[0], deviation};
}

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Matches around one, itself first, nearest first.
struct Samples {
  std::vector<Eigen::Vector2d> offsets;  ///< in the left picture, pixels
  std::vector<double> disparities, sigma;
};

/// The local surface: the disparity as a quadratic of the place in the left picture.
struct LocalSurface {
  double disparity = 0.0, sigma = 0.0;              ///< at the match itself
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< of the disparity
  double residual = 0.0, residual_sigma = 0.0;      ///< of the match itself
};

class LocalFit {
 public:
  /// @param reach pixels: errors at a distance are alike by exp(-(distance / reach)^2 / 4).
  /// @param bend standard deviation of the quadratic's coefficients before anything is seen, 1 / pixel.
  LocalFit(const Samples& samples, double reach, double bend)
      : samples_(samples), reach_(reach), bend_(bend) {}

  /// Through the first `count` samples.
  LocalSurface through(std::size_t count) const {
    double radius = 1.0;
    for (std::size_t k = 1; k < count; ++k) radius = std::max(radius, kWidth * samples_.offsets[k].norm());
    std::vector<double> distance_weights, robust(count, 1.0);
    std::vector<Vector6> rows;
    for (std::size_t k = 0; k < count; ++k) {
      const Eigen::Vector2d o = samples_.offsets[k] / radius;
      rows.push_back(
          (Vector6() << 1.0, o.x(), o.y(), o.x() * o.x(), o.x() * o.y(), o.y() * o.y()).finished());
      distance_weights.push_back(std::exp(-o.squaredNorm()) / (samples_.sigma[k] * samples_.sigma[k]));
    }
    const double looseness = 1.0 / std::pow(bend_ * radius * radius, 2);
    const Vector6 prior = (Vector6() << 1e-9, 1e-4, 1e-4, looseness, looseness, looseness).finished();
    Eigen::LDLT<Matrix6> factor;
    Vector6 c = Vector6::Zero();
    std::vector<double> weights(count);
    for (int pass = 0; pass < kPasses; ++pass) {
      Matrix6 normal = prior.asDiagonal();
      Vector6 right = Vector6::Zero();
      for (std::size_t k = 0; k < count; ++k) {
        weights[k] = distance_weights[k] * robust[k];
        normal.noalias() += weights[k] * rows[k] * rows[k].transpose();
        right += weights[k] * samples_.disparities[k] * rows[k];
      }
      factor.compute(normal);
      c = factor.solve(right);
      for (std::size_t k = 0; k < count; ++k)
        robust[k] = std::max(1e-6, tukey((samples_.disparities[k] - rows[k].dot(c)) /
                                         (kTukey * (samples_.sigma[k] + kSlack))));
    }
    LocalSurface surface;
    surface.disparity = c[0];
    surface.slope = Eigen::Vector2d(c[1], c[2]) / radius;
    surface.residual = samples_.disparities[0] - c[0];
    propagate(surface, factor.solve(Vector6::Unit(0)), rows, weights, prior);
    return surface;
  }

 private:
  static constexpr double kWidth = 0.7;  ///< of the weights, in the farthest neighbour's distance
  static constexpr double kTukey = 4.7, kSlack = 0.02;  ///< pixels
  static constexpr int kPasses = 3;

  void propagate(LocalSurface& surface, const Vector6& first, const std::vector<Vector6>& rows,
                 const std::vector<double>& weights, const Vector6& prior) const {
    std::vector<double> influence;
    for (std::size_t k = 0; k < rows.size(); ++k) influence.push_back(weights[k] * first.dot(rows[k]));
    const auto variance = [&] {
      double sum = 0.0;
      for (std::size_t j = 0; j < influence.size(); ++j)
        for (std::size_t k = 0; k < influence.size(); ++k)
          sum +=
              influence[j] * influence[k] * samples_.sigma[j] * samples_.sigma[k] *
              std::exp(-(samples_.offsets[j] - samples_.offsets[k]).squaredNorm() / (4.0 * reach_ * reach_));
      return std::max(0.0, sum);
    };
    // What the curvature may be beside what is seen.
    const double bent = first.tail<3>().cwiseAbs2().dot(prior.tail<3>());
    surface.sigma = std::sqrt(variance() + bent);
    influence[0] -= 1.0;
    surface.residual_sigma = std::sqrt(variance() + bent);
  }

  const Samples& samples_;
  double reach_, bend_;
};

/// The fit through the widest neighbourhood that agrees with all narrower ones (intersection of confidence
/// intervals, Katkovnik 1999). So it stays narrow at an edge, or where the surface is no quadratic.
LocalSurface widest_that_agrees(const LocalFit& fit, const Samples& samples) {
  constexpr std::size_t kSizes[] = {9, 13, 18, 25};
  constexpr double kConfidence = 0.5;  // measured: more smooths edges away, less leaves the noise
  double low = samples.disparities[0] - kConfidence * samples.sigma[0],
         high = samples.disparities[0] + kConfidence * samples.sigma[0];
  LocalSurface best;
  best.disparity = samples.disparities[0];
  best.sigma = samples.sigma[0];
  bool first = true;
  for (const std::size_t size : kSizes) {
    if (size > samples.offsets.size() && !first) break;
    const LocalSurface surface = fit.through(std::min(size, samples.offsets.size()));
    if (first) best.slope = surface.slope;  // a normal there must be
    first = false;
    low = std::max(low, surface.disparity - kConfidence * surface.sigma);
    high = std::min(high, surface.disparity + kConfidence * surface.sigma);
    if (low > high) break;
    best = surface;
  }
  return best;
}

}  // namespace

std::vector<std::vector<int>> nearest_in_picture(const std::vector<Eigen::Vector2d>& points, int k) {
  std::vector<std::vector<int>> result(points.size());
  if (points.size() < 2) return result;
  Eigen::Vector2d low = points[0], high = points[0];
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector2d extent = (high - low).cwiseMax(1.0);
  // Buckets of about two points, searched in growing rings until no farther ring can hold a nearer point.
  const double side = std::max(1.0, std::sqrt(2.0 * extent.prod() / static_cast<double>(points.size())));
  const int columns = static_cast<int>(extent.x() / side) + 1, rows = static_cast<int>(extent.y() / side) + 1;
  const auto cell = [&](const Eigen::Vector2d& p) {
    return std::pair(static_cast<int>((p.x() - low.x()) / side), static_cast<int>((p.y() - low.y()) / side));
  };
  const auto bucket = [columns](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
  };
  std::vector<std::vector<int>> buckets(bucket(0, rows));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = cell(points[i]);
    buckets[bucket(x, y)].push_back(static_cast<int>(i));
  }
  const auto wanted = std::min(static_cast<std::size_t>(k), points.size() - 1);
  std::vector<std::pair<double, int>> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    found.clear();
    const auto [cx, cy] = cell(points[i]);
    for (int ring = 0; ring <= std::max(columns, rows); ++ring) {
      for (int y = std::max(0, cy - ring); y <= std::min(rows - 1, cy + ring); ++y)
        for (int x = std::max(0, cx - ring); x <= std::min(columns - 1, cx + ring); ++x) {
          if (std::max(std::abs(x - cx), std::abs(y - cy)) != ring) continue;
          for (const int j : buckets[bucket(x, y)])
            if (j != static_cast<int>(i))
              found.emplace_back((points[static_cast<std::size_t>(j)] - points[i]).squaredNorm(), j);
        }
      if (found.size() < wanted) continue;
      std::sort(found.begin(), found.end());
      if (found[wanted - 1].first <= side * side * ring * ring) break;
    }
    for (std::size_t m = 0; m < wanted; ++m) result[i].push_back(found[m].second);
  }
  return result;
}

std::vector<bool> agreeing(const Rectification& rectification, const std::vector<Match>& matches) {
  constexpr int kNeighbours = 12;
  std::vector<Eigen::Vector2d> places;
  places.reserve(matches.size());
  for (const Match& m : matches) places.push_back(m.left);
  const auto neighbours = nearest_in_picture(places, kNeighbours);
  const double lonely = 0.12 * rectification.width();
  std::vector<bool> kept(matches.size(), false);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    std::vector<Eigen::Vector3d> samples;
    for (const int j : neighbours[i]) {
      const Match& other = matches[static_cast<std::size_t>(j)];
      const Eigen::Vector2d offset = other.left - matches[i].left;
      if (offset.norm() > lonely) continue;
      samples.emplace_back(offset.x(), offset.y(), rectification.disparity(other.left, other.right));
    }
    if (samples.size() < 4) continue;
    const auto [expected, deviation] = plane_at_origin(samples);
    const double miss = std::abs(rectification.disparity(matches[i].left, matches[i].right) - expected);
    kept[i] = miss <= std::max({0.5, 3.0 * deviation, 3.0 * matches[i].sigma});
  }
  return kept;
}

Surface fit_surface(const Rectification& rectification, const std::vector<Match>& matches, double reach,
                    bool move) {
  constexpr int kNeighbours = 24;
  constexpr std::size_t kFewest = 6, kCheck = 9;
  std::vector<Eigen::Vector2d> places;
  places.reserve(matches.size());
  for (const Match& m : matches) places.push_back(m.left);
  const auto neighbours = nearest_in_picture(places, kNeighbours);
  const auto samples_of = [&](std::size_t i, double scale) {
    Samples samples;
    const auto add = [&](std::size_t j) {
      samples.offsets.push_back(matches[j].left - matches[i].left);
      samples.disparities.push_back(rectification.disparity(matches[j].left, matches[j].right));
      samples.sigma.push_back(scale * matches[j].sigma);
    };
    add(i);
    for (const int j : neighbours[i]) add(static_cast<std::size_t>(j));
    return samples;
  };
  const double bend = rectification.bend_prior();
  Surface result;
  std::vector<double> squares;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Samples samples = samples_of(i, 1.0);
    if (samples.offsets.size() < kCheck) continue;
    const LocalSurface surface = LocalFit(samples, reach, bend).through(kCheck);
    squares.push_back(std::pow(surface.residual / surface.residual_sigma, 2));
  }
  if (squares.size() >= 30) result.misfit = std::sqrt(upper_median(std::move(squares)) / kMedianOfChiSquare);
  const double scale = std::max(1.0, result.misfit);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Samples samples = samples_of(i, scale);
    LocalSurface surface;
    surface.disparity = samples.disparities[0];
    surface.sigma = samples.sigma[0];
    if (samples.offsets.size() >= kFewest) {
      const LocalSurface found = widest_that_agrees(LocalFit(samples, reach, bend), samples);
      surface.slope = found.slope;
      if (move && found.disparity > 0.0) surface.disparity = found.disparity, surface.sigma = found.sigma;
    }
    result.points.push_back({surface.disparity, surface.sigma,
                             rectification.normal(matches[i].left, surface.disparity, surface.slope)});
  }
  return result;
}

}  // namespace glisson::stereo
