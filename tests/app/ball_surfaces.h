// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/geometry/mesh_io.h"
#include "program.h"

namespace glisson::test {

/// Writes the surfaces of a liver that is a ball, and of a lesion in it, to a new folder.
inline void write_ball_surfaces(const std::filesystem::path& folder) {
  std::filesystem::create_directory(folder);
  const TriangleMesh liver = boundary_surface(ball(8)).mesh;
  TriangleMesh lesion = liver;
  lesion.vertices = 0.12 * liver.vertices;
  lesion.vertices.col(2) *= 2.0;
  lesion.vertices.rowwise() += Eigen::RowVector3d(0.03, 0.0, -0.01);
  write_triangle_mesh(folder / "liver.stl", liver, LengthUnit::millimetre);
  write_triangle_mesh(folder / "lesions.stl", lesion, LengthUnit::millimetre);
}

}  // namespace glisson::test
