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

/// A point with its surface.
struct SurfacePoint {
  Eigen::Vector3d point, normal;
  double sigma = 0.0;
};
/// Moving least squares (Levin 2003; Alexa et al. 2003): a plane through the neighbours by weighted principal
/// axes, a quadratic over it by weighted least squares, the point moved along its own ray onto it (noise of
/// triangulation lies along the ray; the pixel that the operator labelled stays). Tukey weights keep
/// neighbours across a step in depth out.
/// @param sigma along each ray, metres. @param move false: only normals are taken from the fit.
std::vector<SurfacePoint> fit_surface(const std::vector<Eigen::Vector3d>& points,
                                      const std::vector<double>& sigma,
                                      const std::vector<std::vector<int>>& neighbours, bool move);

}  // namespace glisson::stereo
