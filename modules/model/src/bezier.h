// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace glisson::model {

struct CubicBezier {
  std::array<Eigen::Vector3d, 4> control;

  Eigen::Vector3d at(double t) const;
  Eigen::Vector3d derivative(double t) const;
  Eigen::Vector3d second_derivative(double t) const;
  /// 1 / length; 0 where the curve stands still.
  double curvature(double t) const;
};

/// Where on a chain of curves a point was fitted.
struct CurveParameter {
  int curve = 0;
  double t = 0.0;
};

/// A chain of cubic curves through the first and the last point, within `tolerance` of the others, with a
/// common tangent where two curves meet (Schneider, "An algorithm for automatically fitting digitized
/// curves", Graphics Gems 1990).
struct CurveChain {
  std::vector<CubicBezier> curves;
  std::vector<CurveParameter> parameters;  ///< one an input point

  Eigen::Vector3d at(CurveParameter p) const { return curves[static_cast<std::size_t>(p.curve)].at(p.t); }
};
/// @pre two points at least, the first and the last distinct from their neighbours.
/// @param tangent_reach points this near to an end or a joint settle its tangent (the points' unit): the
/// steps of a voxel path say nothing of its direction.
CurveChain fit_curves(const std::vector<Eigen::Vector3d>& points, double tolerance, double tangent_reach);

}  // namespace glisson::model
