// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/mesh.h"
#include "point_drift.h"
#include "surface_samples.h"

/// @file
/// How a template lies on a liver as a whole: similarities that few points find and more refine. Lengths are
/// in units of each shape's size, about its centre, but where metres are named.

namespace glisson::atlas {

/// The template.
struct Moving {
  Oriented all, some, few;  ///< its vertices; those that drift; those that find the start
  std::vector<int> at;      ///< vertices that `some` are
  double size = 0.0;        ///< metres
  Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();  ///< metres
};
/// @param still the template's surface, metres
Moving moving_parts(const TriangleMesh& still);

/// The liver that it is brought onto.
struct Target {
  SurfaceSamples fine;                                     ///< metres
  Oriented all, some, few;                                 ///< the same; coarser; coarser still
  double size = 0.0;                                       ///< metres
  Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();  ///< metres
};
/// @param liver metres @pre it has a surface
Target target_parts(const TriangleMesh& liver);

/// Axes of the CT that are turned round: of x, y and z the bits 1, 2 and 4.
using Axes = unsigned;
inline constexpr Axes kNoAxes = 0, kLeftRight = 1, kFrontBack = 2, kHeadFeet = 4, kAllAxes = 7;

/// An image's misfit over the misfit of the liver as it lies, both held upright, below which axes are
/// exchanged. Of twelve real livers of development the best image has 1.25 and more, their images' 0.80 and
/// less; livers cut to half, stretched by 1.4 or turned by 30 degrees have 0.98 and more.
inline constexpr double kExchanged = 0.9;

/// The template on the image of the liver in which these axes are turned round, held as livers lie in a CT.
Pose upright_pose(const Moving& moving, const Target& liver, Axes turned_round = kNoAxes);
/// The same in the best of the 24 orientations of a cube; as it stands unless another is clearly better.
Pose free_pose(const Moving& moving, const Target& liver, Axes turned_round = kNoAxes);

}  // namespace glisson::atlas
