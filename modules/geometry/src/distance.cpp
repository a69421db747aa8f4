// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/closest_point_tree.h"

namespace glisson {

DistanceSummary summarise(std::vector<double> distances) {
  DistanceSummary summary;
  summary.count = static_cast<int>(distances.size());
  if (distances.empty()) return summary;
  std::sort(distances.begin(), distances.end());
  const double n = static_cast<double>(distances.size());
  summary.mean = std::accumulate(distances.begin(), distances.end(), 0.0) / n;
  summary.rms = std::sqrt(std::inner_product(distances.begin(), distances.end(), distances.begin(), 0.0) / n);
  summary.median = interpolated_percentile(distances, 0.5);
  summary.percentile_95 = interpolated_percentile(distances, 0.95);
  summary.maximum = distances.back();
  return summary;
}

std::vector<double> distances_to_surface(const Points& points, const TriangleMesh& surface) {
  const ClosestPointTree tree(surface);
  std::vector<double> distances(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    distances[static_cast<std::size_t>(i)] = tree.closest(points.row(i).transpose()).distance;
  return distances;
}

Points sample_surface(const TriangleMesh& surface, int count, unsigned seed) {
  const Eigen::VectorXd areas = triangle_areas(surface);
  const double total = areas.sum();
  require(total > 0.0 && count >= 0, "sample_surface needs a surface with an area");
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Points samples(count, 3);
  double reached = 0.0;
  int triangle = -1;
  for (int i = 0; i < count; ++i) {
    const double wanted = (i + uniform(random)) / count * total;  // one sample a stratum of equal area
    while (triangle + 1 < surface.triangle_count() && (triangle < 0 || reached < wanted))
      reached += areas[++triangle];
    const double root = std::sqrt(uniform(random)), v = uniform(random);
    samples.row(i) = (1.0 - root) * surface.vertices.row(surface.triangles(triangle, 0)) +
                     root * (1.0 - v) * surface.vertices.row(surface.triangles(triangle, 1)) +
                     root * v * surface.vertices.row(surface.triangles(triangle, 2));
  }
  return samples;
}

SurfaceDistance surface_distance(const TriangleMesh& a, const TriangleMesh& b, int samples) {
  return {summarise(distances_to_surface(sample_surface(a, samples, 1), b)),
          summarise(distances_to_surface(sample_surface(b, samples, 1), a))};
}

SetDistance set_distance(const Points& a, const Points& b) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (a.rows() == 0 || b.rows() == 0) return {kNone, kNone};
  SetDistance distance;
  const auto one_way = [&distance](const Points& from, const Points& to) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < from.rows(); ++i) {
      const double closest = std::sqrt((to.rowwise() - from.row(i)).rowwise().squaredNorm().minCoeff());
      sum += closest;
      distance.largest = std::max(distance.largest, closest);
    }
    return sum / static_cast<double>(from.rows());
  };
  distance.mean = 0.5 * (one_way(a, b) + one_way(b, a));
  return distance;
}

DistanceSummary point_errors(const Points& a, const Points& b) {
  require(a.rows() == b.rows(), "point_errors needs as many points on both sides");
  std::vector<double> distances(static_cast<std::size_t>(a.rows()));
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    distances[static_cast<std::size_t>(i)] = (a.row(i) - b.row(i)).norm();
  return summarise(std::move(distances));
}

}  // namespace glisson
