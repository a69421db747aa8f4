// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/picture.h"
#include "glisson/stereo/regions.h"

namespace glisson::stereo {

/// How finely density is mapped, and what is enough.
struct DensityOptions {
  int cell = 8;                ///< side of a cell, pixels
  double least_per_cm2 = 0.7;  ///< the paper's need
  /// @throws PreconditionError unless a cell has 2 to 200 pixels and the need is positive.
  void validate() const;
};

/// How densely a cloud covers what the left picture shows. Cells row by row.
struct DensityMap {
  int columns = 0, rows = 0, cell = 8;
  /// Points per cm2 in the square centimetre of surface around a cell; 0: none is near; negative: nothing is
  /// wanted there (outside mask and regions).
  std::vector<float> per_cm2;
  double least_per_cm2 = 0.7;
  double area_cm2 = 0.0;  ///< of the surface that is wanted, at the depth and slant of the closest points
  double covered = 0.0;   ///< share of that area with `least_per_cm2` and more

  /// Of a cell. @pre within columns and rows.
  float at(int column, int row) const {
    return per_cm2[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column)];
  }
};

/// @param mask empty, or one byte a pixel of the left picture (non-zero is wanted). @param regions those on
///   the left picture bound what is wanted; without mask and regions it is the whole picture.
/// @pre points with normals; valid options; a mask of the camera's size.
DensityMap density_map(const LabelledCloud& cloud, const Camera& left, const Picture& mask,
                       const Regions& regions, const DensityOptions& options = {});

/// "cloud_area_cm2": DensityMap::area_cm2.
Figures density_figures(const DensityMap& map);

/// The left picture with its cells: blue where there are enough points, orange where they are missing
/// (darker: none at all). Three channels.
Picture density_picture(const DensityMap& map, const Picture& left);

}  // namespace glisson::stereo
