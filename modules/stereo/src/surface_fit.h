// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "matching.h"

namespace glisson::stereo {

/// Indices of the k nearest others of each point, nearest first (in the picture: the surface has one depth a
/// pixel).
std::vector<std::vector<int>> nearest_in_picture(const std::vector<Eigen::Vector2d>& points, int k);

/// Which matches agree with their neighbours: disparity is linear over a plane, so a robust plane of the
/// neighbours' disparities predicts it. Out is what misses by more than 3 robust deviations (and more than
/// half a pixel), and what has nobody near.
std::vector<bool> agreeing(const Rectification& rectification, const std::vector<Match>& matches);

/// A match with its surface.
struct SurfacePoint {
  double disparity = 0.0, sigma = 0.0;  ///< pixels
  Eigen::Vector3d normal;               ///< left camera's frame, unit, towards the camera
};
struct Surface {
  std::vector<SurfacePoint> points;
  /// How far matches lie off their neighbours' surface, over what their sigmas let expect: 1 where those are
  /// right. Where it is more, sigmas are raised by it.
  double misfit = 1.0;
};
/// Moving least squares (Levin 2003) over the rectified left picture: a quadratic of the disparity through
/// the neighbours. The disparity is what is measured, is linear over a plane, and all of its error lies along
/// the ray; the pixel that the operator labelled stays. Tukey weights and neighbourhoods that end where the
/// surface does keep steps in depth.
/// @param reach standard deviation of the patches' weights, pixels: patches overlap, and errors within a
///   distance are alike by exp(-(distance / reach)^2 / 4), which enters the sigmas.
/// @param move false: only normals and misfit are taken from the fit.
Surface fit_surface(const Rectification& rectification, const std::vector<Match>& matches, double reach,
                    bool move);

}  // namespace glisson::stereo
