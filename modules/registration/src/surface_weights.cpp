// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_weights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glisson/core/statistics.h"

namespace glisson::registration {
namespace {

/// As many as the point has in its own look, of all looks: what is seen twice counts once.
std::vector<int> around(const PreparedCloud& cloud, int point) {
  const std::vector<int>& own = cloud.neighbours[static_cast<std::size_t>(point)];
  if (cloud.cloud.look_count() == 1 || own.empty()) return own;
  const Eigen::VectorXd distances =
      (cloud.cloud.points.rowwise() - cloud.cloud.points.row(point)).rowwise().squaredNorm();
  std::vector<int> others;
  for (int i = 0; i < cloud.cloud.size(); ++i)
    if (i != point) others.push_back(i);
  const auto count = static_cast<std::ptrdiff_t>(own.size());
  std::partial_sort(others.begin(), others.begin() + count, others.end(),
                    [&](int a, int b) { return distances[a] < distances[b]; });
  others.resize(own.size());
  return others;
}

}  // namespace

double area_of_point(const Points& points, Eigen::Index point, const std::vector<int>& neighbours) {
  const double reach = (points.row(neighbours.back()) - points.row(point)).squaredNorm();
  return std::numbers::pi * reach / static_cast<double>(neighbours.size());
}

std::vector<double> surface_weights(const PreparedCloud& cloud) {
  std::vector<double> weights = cloud.weight, of_surface;
  for (int i = 0; i < cloud.cloud.size(); ++i)
    if (cloud.cloud.feature(i) == Feature::surface)
      of_surface.push_back(cloud.weight[static_cast<std::size_t>(i)]);
  if (of_surface.size() == weights.size()) return weights;
  const double reference_area = 1e-4 / CloudOptions().reference_density_per_cm2;
  const double most = of_surface.empty() ? 0.0 : kMostOfMedian * upper_median(std::move(of_surface));
  for (int i = 0; i < cloud.cloud.size(); ++i)
    if (cloud.cloud.feature(i) != Feature::surface)
      weights[static_cast<std::size_t>(i)] =
          std::min(most, area_of_point(cloud.cloud.points, i, around(cloud, i)) / reference_area);
  return weights;
}

}  // namespace glisson::registration
