// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_faces.h"

#include <array>

#include "glisson/core/error.h"

namespace glisson::model {
namespace {

using Rectangle = std::array<Eigen::Vector3d, 4>;  ///< corners in turn, CT, metres

TriangleMesh mesh_of(const std::vector<Rectangle>& rectangles) {
  TriangleMesh mesh;
  mesh.vertices.resize(4 * static_cast<Eigen::Index>(rectangles.size()), 3);
  mesh.triangles.resize(2 * static_cast<Eigen::Index>(rectangles.size()), 3);
  for (std::size_t r = 0; r < rectangles.size(); ++r) {
    const int first = 4 * static_cast<int>(r);
    for (int k = 0; k < 4; ++k) mesh.vertices.row(first + k) = rectangles[r][k].transpose();
    mesh.triangles.row(first / 2) << first, first + 1, first + 2;
    mesh.triangles.row(first / 2 + 1) << first, first + 2, first + 3;
  }
  return mesh;
}

}  // namespace

TriangleMesh cut_faces(const VolumeGrid& grid, const std::vector<std::uint8_t>& organ) {
  require(static_cast<long>(organ.size()) == grid.voxel_count(), "an organ has the image's voxels");
  std::vector<Rectangle> rectangles;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      Eigen::Vector3i at;
      at[axis] = high ? grid.size[axis] - 1 : 0;
      const auto corner = [&](double along_u, double along_v) {
        Eigen::Vector3d index;
        index[axis] = at[axis] + (high ? 0.5 : -0.5);
        index[u] = along_u;
        index[v] = along_v;
        return grid.p_in_ct(index).xyz;
      };
      for (at[v] = 0; at[v] < grid.size[v]; ++at[v]) {
        int first = -1;  // of a row of voxels
        for (at[u] = 0; at[u] <= grid.size[u]; ++at[u]) {
          const bool is_set = at[u] < grid.size[u] && organ[static_cast<std::size_t>(grid.offset(at))] != 0;
          if (is_set && first < 0) first = at[u];
          if (is_set || first < 0) continue;
          rectangles.push_back({corner(first - 0.5, at[v] - 0.5), corner(at[u] - 0.5, at[v] - 0.5),
                                corner(at[u] - 0.5, at[v] + 0.5), corner(first - 0.5, at[v] + 0.5)});
          first = -1;
        }
      }
    }
  }
  return mesh_of(rectangles);
}

}  // namespace glisson::model
