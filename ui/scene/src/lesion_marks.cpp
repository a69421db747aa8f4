// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesion_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glisson/ui/scene/surface_raster.h"

namespace glisson::scene {
namespace {

/// How a pixel answers to a point, pixels per metre.
Eigen::Matrix<double, 2, 3> jacobian(const Camera& camera, const Eigen::Vector3d& p) {
  constexpr double kStep = 1e-5;
  Eigen::Matrix<double, 2, 3> result;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k);
    result.col(k) = (camera.project(p + step) - camera.project(p - step)) / (2.0 * kStep);
  }
  return result;
}

/// Of an ellipse, where its normal is `outwards`.
Eigen::Vector2d rim_of(const Eigen::Matrix2d& ellipse, const Eigen::Vector2d& outwards) {
  return ellipse * outwards / std::sqrt(std::max(outwards.dot(ellipse * outwards), 1e-12));
}

}  // namespace

std::vector<LesionVerdict> verdicts_of(const std::vector<Label>& lesions, const OverlayFrame& overlay) {
  std::vector<LesionVerdict> verdicts;
  for (const Label lesion : lesions) {
    const auto found = std::find_if(overlay.lesions.begin(), overlay.lesions.end(),
                                    [lesion](const LesionVerdict& one) { return one.lesion == lesion; });
    LesionVerdict verdict;
    verdict.lesion = lesion;
    if (found != overlay.lesions.end()) verdict = *found;
    if (overlay.level() > verdict.level) {
      verdict.level = overlay.level();
      verdict.reason = LesionReason::with_the_whole;
    }
    verdicts.push_back(verdict);
  }
  return verdicts;
}

QPolygonF region_of(const LesionVerdict& verdict, const Camera& camera) {
  constexpr double kChiSquare = 5.9915;  // 95 % of chi-square with two degrees of freedom
  constexpr int kCorners = 72;
  const Eigen::Vector3d& centre = verdict.centre;
  if (!SurfaceRaster::is_mapped(camera, centre) || !(verdict.reach > 0.0)) return {};
  const Eigen::Matrix<double, 2, 3> answers = jacobian(camera, centre);
  const Eigen::Matrix2d place = kChiSquare * answers * verdict.covariance * answers.transpose();
  const Eigen::Matrix2d body = verdict.radius * verdict.radius * answers * answers.transpose();
  const Eigen::Vector2d middle = camera.project(centre);
  QPolygonF region;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    const Eigen::Vector2d outwards(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d rim = middle + rim_of(place, outwards) + rim_of(body, outwards);
    region << QPointF(rim.x() + 0.5, rim.y() + 0.5);
  }
  return region;
}

}  // namespace glisson::scene
