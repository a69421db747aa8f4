// SPDX-License-Identifier: GPL-3.0-or-later
#include "unmarked.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "glisson/registration/rivals.h"

namespace glisson::registration {
namespace {

constexpr double kPlace = 25e-3;              ///< m along the margin
constexpr double kReach = 4e-3;               ///< m: what lies nearer to the line is the margin
constexpr double kNear = 2.0 * kMarginSigma;  ///< m: from a mark; what lies nearer may be what it marks
constexpr double kFar = 10e-3;                ///< m: from the model; what lies farther shows nothing of it
constexpr double kLeftOut = 0.2;              ///< probability that a place that is seen is not marked

/// Where a place of the model is in the CT.
Eigen::RowVector3d in_ct(const PatientModel& model, const Carrier& carrier) {
  Eigen::RowVector3d p = Eigen::RowVector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    if (carrier.nodes[k] >= 0) p += carrier.weights[k] * model.mesh.vertices.row(carrier.nodes[k]);
  return p;
}

bool is_on(const Points& line, const Eigen::RowVector3d& p) {
  for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
    const Eigen::RowVector3d way = line.row(i + 1) - line.row(i);
    const double along =
        std::clamp((p - line.row(i)).dot(way) / std::max(way.squaredNorm(), 1e-18), 0.0, 1.0);
    if ((line.row(i) + along * way - p).norm() < kReach) return true;
  }
  return false;
}

}  // namespace

double unmarked_cost(const PatientModel& model, const PreparedCloud& prepared, const MovingSurface& surface,
                     double information) {
  const LabelledCloud& cloud = prepared.cloud;
  if (cloud.features.empty() || cloud.seen_from.rows() > 0) return 0.0;
  std::vector<Eigen::RowVector3d> marks;
  for (int i = 0; i < cloud.size(); ++i)
    if (cloud.feature(i) == Feature::anterior_margin) marks.emplace_back(cloud.points.row(i));
  const double area = 1e-4 / CloudOptions().reference_density_per_cm2;  // m2 that a weight of 1 stands for
  double places = 0.0;
  for (int i = 0; i < cloud.size(); ++i) {
    if (cloud.feature(i) != Feature::surface) continue;
    const Eigen::RowVector3d p = cloud.points.row(i);
    if (std::any_of(marks.begin(), marks.end(),
                    [&](const Eigen::RowVector3d& mark) { return (mark - p).norm() < kNear; }))
      continue;
    const ClosestPoint at = surface.closest(Feature::surface, p.transpose());
    const Eigen::RowVector3d rest = in_ct(model, surface.carrier(at));
    if (at.distance > kFar || !is_on(model.landmarks.anterior_margin, rest)) continue;
    // Where the model's margin is uncertain it tells less.
    places += landmark_share(Feature::anterior_margin, margin_deviation_at(model.landmarks, rest)) * area *
              prepared.surface_weight[static_cast<std::size_t>(i)] / (kPlace * 2.0 * kReach);
  }
  if (marks.empty()) places = std::min(places, 1.0);
  return -2.0 * votes_of_a_place(information) * std::log(kLeftOut) * places;
}

}  // namespace glisson::registration
