// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/geometry/mesh.h"

/// @file
/// Samples that are a function of a surface and not of the vertices and triangles that tell it: integrals
/// over its pieces in the cells of a grid. Metres.

namespace glisson::atlas {

struct SurfaceSamples {
  Points points, normals;   ///< unit normals
  Eigen::VectorXd weights;  ///< shares of the surface's area, their sum is 1
  Eigen::MatrixXd values;   ///< one row a point, or no column

  /// Root of the mean squared distance from the centre.
  double size() const;
  Eigen::RowVector3d centre() const { return weights.transpose() * points; }
};

/// Many points that stand for the whole surface: triangles cut until no edge is longer than `grain` (metres),
/// each with its area and its triangle's normal.
SurfaceSamples dense_samples(const TriangleMesh& surface, double grain);

/// One sample for each cell of a cubic grid about the centre of `dense`, and for each of six directions that
/// the surface may face there: the mean of what lies in it. A little of the surface more or less in a cell
/// changes its weight a little, so that the samples follow the surface without jumps. Samples of cells of a
/// third of the edge give the same.
/// @param cell edge of a cell, metres
SurfaceSamples cell_samples(const SurfaceSamples& dense, double cell);

}  // namespace glisson::atlas
