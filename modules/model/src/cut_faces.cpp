// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_faces.h"

#include <array>

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

TriangleMesh cut_faces(const VolumeGrid& grid, const std::vector<CutRow>& rows) {
  std::vector<Rectangle> rectangles;
  for (const CutRow& row : rows) {
    const int u = (row.axis + 1) % 3, v = (row.axis + 2) % 3;
    const auto corner = [&](double along_u, double along_v) {
      Eigen::Vector3d index;
      index[row.axis] = row.first[row.axis] + (row.high ? 0.5 : -0.5);
      index[u] = along_u;
      index[v] = along_v;
      return grid.p_in_ct(index).xyz;
    };
    const double first = row.first[u] - 0.5, end = row.first[u] + row.count - 0.5;
    const double low = row.first[v] - 0.5, high = row.first[v] + 0.5;
    rectangles.push_back({corner(first, low), corner(end, low), corner(end, high), corner(first, high)});
  }
  return mesh_of(rectangles);
}

}  // namespace glisson::model
