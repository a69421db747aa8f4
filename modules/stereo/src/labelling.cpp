// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/labelling.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "glisson/core/error.h"

namespace glisson::stereo {
namespace {

constexpr int kCell = 8;            // pixels: the area is summed over cells of this side
constexpr double kMostSlant = 0.2;  // cosine: a cell at the organ's rim does not count as endless

/// Where both pictures show a point.
struct Seen {
  Eigen::Vector2d left, right;
  bool in_left = false, in_right = false;
};

Seen seen(const StereoRig& rig, const Eigen::Vector3d& p) {
  Seen s;
  if (p.z() > 0.0) s.left = rig.left.project(p), s.in_left = rig.left.sees(s.left);
  const Eigen::Vector3d in_right = rig.right_from_left.rotation * p + rig.right_from_left.translation;
  if (in_right.z() > 0.0) s.right = rig.right.project(in_right), s.in_right = rig.right.sees(s.right);
  return s;
}

std::optional<Feature> feature_of(const Regions& regions, const Seen& s) {
  const auto by_left = s.in_left ? feature_at(regions, Side::left, s.left) : std::nullopt;
  const auto by_right = s.in_right ? feature_at(regions, Side::right, s.right) : std::nullopt;
  if (by_left && by_right) return std::max(*by_left, *by_right);
  return by_left ? by_left : by_right;
}

bool is_used(const Picture& mask, int x, int y) {
  if (mask.empty()) return true;
  const auto at = static_cast<std::size_t>((y * mask.width + x) * mask.channels);
  return std::any_of(mask.bytes->begin() + static_cast<std::ptrdiff_t>(at),
                     mask.bytes->begin() + static_cast<std::ptrdiff_t>(at + mask.channels),
                     [](std::uint8_t value) { return value != 0; });
}

/// Cells of the left picture within the regions, each at the depth and slant of its closest point.
double area_cm2(const LabelledCloud& whole, const std::vector<Seen>& places, const StereoRig& rig,
                const Picture& mask, const Regions& regions) {
  const bool on_right = std::any_of(regions.regions.begin(), regions.regions.end(),
                                    [](const Region& region) { return region.side == Side::right; });
  double area = 0.0;
  for (int y = kCell / 2; y < rig.left.height; y += kCell)
    for (int x = kCell / 2; x < rig.left.width; x += kCell) {
      const Eigen::Vector2d pixel(x, y);
      const bool by_left = feature_at(regions, Side::left, pixel).has_value();
      if (!is_used(mask, x, y) || (!by_left && !on_right)) continue;
      std::size_t best = places.size();
      double distance = HUGE_VAL;
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double d = (places[i].left - pixel).squaredNorm();
        if (places[i].in_left && d < distance) distance = d, best = i;
      }
      if (best == places.size()) continue;
      const Eigen::Vector3d p = whole.points.row(static_cast<Eigen::Index>(best)).transpose();
      if (!by_left) {
        const auto ray = rig.left.mapped_ray(pixel);
        if (!ray || !feature_of(regions, seen(rig, p.z() * *ray))) continue;
      }
      const Eigen::Vector3d n = whole.normals.row(static_cast<Eigen::Index>(best)).transpose();
      const double side = kCell * p.z();
      area += side * side / (rig.left.matrix(0, 0) * rig.left.matrix(1, 1)) /
              std::max(kMostSlant, std::abs(n.dot(p)) / p.z());
    }
  return 1e4 * area;
}

}  // namespace

LabelledPart label(const LabelledCloud& whole, const StereoRig& rig, const Picture& mask,
                   const Regions& regions) {
  require(whole.normals.rows() == whole.points.rows(), "a normal for each point");
  LabelledPart part;
  std::vector<Seen> places;
  std::vector<Feature> features;
  for (int i = 0; i < whole.size(); ++i) {
    places.push_back(seen(rig, whole.points.row(i).transpose()));
    const auto feature = regions.regions.empty() ? Feature::surface : feature_of(regions, places.back());
    if (!feature) continue;
    part.kept.push_back(i);
    features.push_back(*feature);
  }
  part.cloud.points = whole.points(part.kept, Eigen::all);
  part.cloud.normals = whole.normals(part.kept, Eigen::all);
  if (!whole.sigma.empty())
    for (const int i : part.kept) part.cloud.sigma.push_back(whole.sigma[static_cast<std::size_t>(i)]);
  part.cloud.features = std::move(features);
  if (!regions.regions.empty()) part.area_cm2 = area_cm2(whole, places, rig, mask, regions);
  if (part.area_cm2 > 0.0) part.density_per_cm2 = part.cloud.size() / part.area_cm2;
  return part;
}

}  // namespace glisson::stereo
