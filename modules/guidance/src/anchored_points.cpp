// SPDX-License-Identifier: GPL-3.0-or-later
#include "anchored_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "glisson/core/statistics.h"

namespace glisson::guidance {
namespace {

constexpr std::size_t kNeighbours = 9;

}  // namespace

bool AnchoredPoints::bind(const FollowedPoint& point, const registration::MovingSurface& surface,
                          double radius) {
  const ClosestPoint at = surface.closest(Feature::surface, point.p_in_camera);
  if (at.triangle < 0 || at.distance > radius) return false;
  const Eigen::Vector3d normal = surface.normal(at);
  if (normal.dot(point.p_in_camera) > 0.0) return false;  // it faces away from the camera: not seen
  anchors_[point.id] = {at, normal.dot(point.p_in_camera - at.point)};
  return true;
}

std::vector<char> AnchoredPoints::rebind(const std::vector<FollowedPoint>& points, const Rebind& rebind) {
  std::vector<char> kept;
  for (const FollowedPoint& point : points) {
    const std::optional<Anchor> now = rebind(point.id, anchor(point.id));
    kept.push_back(now ? 1 : 0);
    if (now)
      anchors_[point.id] = *now;
    else
      anchors_.erase(point.id);
  }
  return kept;
}

void AnchoredPoints::retain(const std::vector<FollowedPoint>& points) {
  std::unordered_map<int, Anchor> kept;
  kept.reserve(points.size());
  for (const FollowedPoint& point : points) {
    const auto found = anchors_.find(point.id);
    if (found != anchors_.end()) kept.insert(*found);
  }
  anchors_ = std::move(kept);
}

std::vector<Eigen::Vector3d> AnchoredPoints::gaps(const std::vector<FollowedPoint>& points,
                                                  const registration::MovingSurface& surface) const {
  std::vector<Eigen::Vector3d> gaps;
  gaps.reserve(points.size());
  for (const FollowedPoint& point : points)
    gaps.push_back(point.p_in_camera - anchor(point.id).place(surface));
  return gaps;
}

RigidMotion AnchoredPoints::common_motion(const std::vector<FollowedPoint>& points,
                                          const registration::MovingSurface& surface) const {
  Points seen(static_cast<Eigen::Index>(points.size()), 3), modelled = seen;
  for (Eigen::Index i = 0; i < seen.rows(); ++i) {
    const FollowedPoint& point = points[static_cast<std::size_t>(i)];
    seen.row(i) = point.p_in_camera.transpose();
    modelled.row(i) = anchor(point.id).place(surface).transpose();
  }
  return fit_rigid_motion(modelled, seen, {});
}

void AnchoredPoints::add(const std::vector<FollowedPoint>& points, const registration::MovingSurface& surface,
                         double stiffness, std::vector<fem::AttachedLoad>& loads) const {
  for (const FollowedPoint& point : points) {
    const Anchor& bound = anchor(point.id);
    const registration::Carrier carrier = surface.carrier(bound.at);
    fem::AttachedLoad load;
    load.nodes = carrier.nodes;
    load.weights = carrier.weights;
    load.tangent = stiffness * point.information;
    load.force = load.tangent * (point.p_in_camera - bound.place(surface));
    loads.push_back(load);
  }
}

std::vector<char> consistent(const std::vector<FollowedPoint>& points,
                             const std::vector<Eigen::Vector3d>& gaps, double deviations, double floor) {
  const std::size_t n = points.size();
  std::vector<double> difference(n, 0.0);
  std::vector<std::pair<double, std::size_t>> near;
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    near.clear();
    for (std::size_t j = 0; j < n; ++j)
      if (j != i) near.emplace_back((points[i].p_in_camera - points[j].p_in_camera).squaredNorm(), j);
    const std::size_t count = std::min(kNeighbours, near.size());
    if (count < 3) continue;
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    Eigen::Vector3d middle;
    for (int axis = 0; axis < 3; ++axis) {
      values.clear();
      for (std::size_t k = 0; k < count; ++k) values.push_back(gaps[near[k].second][axis]);
      middle[axis] = upper_median(values);
    }
    const Eigen::Vector3d d = gaps[i] - middle;
    difference[i] = std::sqrt(std::max(0.0, d.dot(points[i].information * d)));
  }
  const double usual = difference.empty() ? 0.0 : upper_median(difference);
  const double limit = std::max(floor, deviations * kDeviationPerMad * usual);
  std::vector<char> result(n);
  for (std::size_t i = 0; i < n; ++i) result[i] = difference[i] <= limit;
  return result;
}

}  // namespace glisson::guidance
