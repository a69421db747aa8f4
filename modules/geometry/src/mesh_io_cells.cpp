// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_io_cells.h"

#include <cmath>

#include "glisson/core/error.h"
#include "vtk_cell_types.h"

namespace glisson::formats {
namespace {

using namespace vtk_cell;

NamedArrays rows_of(const NamedArrays& arrays, const std::vector<long>& rows, long cells) {
  NamedArrays chosen;
  for (const auto& [name, values] : arrays) {
    if (values.rows() != cells) continue;
    Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()), values.cols());
    for (std::size_t r = 0; r < rows.size(); ++r)
      part.row(static_cast<Eigen::Index>(r)) = values.row(rows[r]);
    chosen[name] = part;
  }
  return chosen;
}

/// Labels leave the arrays and become the mesh's own.
void take_labels(TetFile& file) {
  for (const char* name : {"label", "labels", "gmsh:physical", "medit:ref"}) {
    const auto found = file.cell_data.find(name);
    if (found == file.cell_data.end() || found->second.cols() != 1 || !found->second.allFinite()) continue;
    for (Eigen::Index t = 0; t < found->second.rows(); ++t)
      file.mesh.labels.push_back(static_cast<int>(std::clamp(std::round(found->second(t, 0)), -1e9, 1e9)));
    file.cell_data.erase(found);
    return;
  }
}

}  // namespace

void CellSorter::add(long type, const std::vector<long>& points) {
  const std::string field = "cell " + std::to_string(count_);
  for (const long point : points)
    if (point < 0 || point >= point_count_)
      throw InputError(path_.string(), field, "names a point that is not there", "Export the mesh anew");
  const auto id = [&](std::size_t k) { return static_cast<int>(points[k]); };
  switch (type) {
    case kTetrahedron:
      if (points.size() != 4)
        throw InputError(path_.string(), field, "is a tetrahedron without four points",
                         "Export the mesh anew");
      tetrahedra_.insert(tetrahedra_.end(), {id(0), id(1), id(2), id(3)});
      tetrahedron_cell_.push_back(count_);
      break;
    case kTriangle:
    case kPolygon:
    case kQuad:
    case kStrip:
      for (std::size_t k = 2; k < points.size(); ++k) {
        const std::size_t first = type == kStrip ? k - 2 + k % 2 : 0,
                          second = type == kStrip ? k - 1 - k % 2 : k - 1;
        triangles_.insert(triangles_.end(), {id(first), id(second), id(k)});
        triangle_cell_.push_back(count_);
      }
      break;
    case kEmpty:
    case kVertex:
    case kPolyVertex:
    case kLine:
    case kPolyLine:
      break;
    default:
      throw InputError(
          path_.string(), field,
          "is of VTK type " + std::to_string(type) + ", neither a linear tetrahedron nor a polygon",
          "Convert the mesh to linear tetrahedra");
  }
  ++count_;
}

MixedFile CellSorter::finish(const Points& points, const NamedArrays& point_data,
                             const NamedArrays& cell_data, const NamedArrays& field_data) const {
  MixedFile file;
  file.tets.mesh.vertices = file.triangles.mesh.vertices = points;
  file.tets.mesh.tetrahedra = Eigen::Map<const Tetrahedra>(
      tetrahedra_.data(), static_cast<Eigen::Index>(tetrahedron_cell_.size()), 4);
  file.triangles.mesh.triangles =
      Eigen::Map<const Triangles>(triangles_.data(), static_cast<Eigen::Index>(triangle_cell_.size()), 3);
  for (const auto& [name, values] : point_data)
    if (values.rows() == points.rows()) file.tets.point_data[name] = file.triangles.point_data[name] = values;
  file.tets.cell_data = rows_of(cell_data, tetrahedron_cell_, count_);
  file.triangles.cell_data = rows_of(cell_data, triangle_cell_, count_);
  file.tets.field_data = file.triangles.field_data = field_data;
  take_labels(file.tets);
  return file;
}

}  // namespace glisson::formats
