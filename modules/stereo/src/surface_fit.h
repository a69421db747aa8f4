// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "matching.h"

namespace glisson::stereo {

/// Indices of the k nearest others of each point, nearest first (in the picture: the surface has one depth a
/// pixel).
std::vector<std::vector<int>> nearest_in_picture(const std::vector<Eigen::Vector2d>& points, int k);

/// Which matches agree with their neighbours. Disparity is linear over a plane, so a robust plane through the
/// neighbours' disparities predicts it. A match is out if it misses by more than 3 robust deviations and more
/// than half a pixel, or has no neighbour near.
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
/// the neighbours. Disparity is fitted because it is what was measured, it is linear over a plane, and its
/// error lies along the ray, so a labelled pixel stays where it is. Steps in depth are kept by Tukey's
/// weights and by neighbourhoods that end where the surface does.
/// @param reach standard deviation of the patches' weights, pixels: patches overlap, and errors within a
///   distance are alike by exp(-(distance / reach)^2 / 4), which enters the sigmas.
/// @param move false: only normals and misfit are taken from the fit.
Surface fit_surface(const Rectification& rectification, const std::vector<Match>& matches, double reach,
                    bool move);

}  // namespace glisson::stereo
