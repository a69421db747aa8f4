// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "glisson/ui/segmentation/edit_tools.h"

/// @file
/// Volumes whose axes are not the patient's, and strokes of a brush through them.

namespace glisson {

inline VolumeGrid permuted_grid() {
  VolumeGrid grid;
  grid.size = {40, 50, 60};
  grid.spacing_mm = {2.5, 0.8, 0.7};
  grid.origin_mm = {-10.0, 20.0, -30.0};
  grid.direction << 0, 1, 0, 0, 0, -1, 1, 0, 0;  // i along z, j along x, k against y
  return grid;
}

/// Turned about x, as the volume of a tilted gantry is.
inline VolumeGrid tilted_grid(double degrees) {
  VolumeGrid grid;
  grid.size = {40, 60, 50};
  const double angle = degrees * std::numbers::pi / 180.0;
  grid.direction = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
  return grid;
}

/// 40 mm from front to back through the middle of a tilted_grid(), half-way between two layers there.
inline Points way_through(const VolumeGrid& grid, int count) {
  const Eigen::Vector3d middle = grid.p_in_ct({19.5, 29.5, 24.5}).xyz;
  Points path(count, 3);
  for (int n = 0; n < count; ++n)
    path.row(n) = (middle + Eigen::Vector3d(0.0, 40e-3 * n / (count - 1) - 20e-3, 0.0)).transpose();
  return path;
}

/// Drawn in the slice that its first point lies in.
inline std::vector<editing::Edit> strokes(ui::EditTool tool, const ui::EditSettings& settings,
                                          const VolumeGrid& grid, scene::Plane plane, const Points& path,
                                          bool invert = false) {
  const Point<CtFrame> start(Eigen::Vector3d(path.row(0).transpose()));
  return ui::brush_edits(tool, settings, grid, scene::slice_geometry(grid, plane, start), path, invert);
}

inline editing::Edit stroke(ui::EditTool tool, const ui::EditSettings& settings, const VolumeGrid& grid,
                            scene::Plane plane, const Points& path, bool invert = false) {
  return strokes(tool, settings, grid, plane, path, invert).at(0);
}

}  // namespace glisson
