// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "mesh_io_formats.h"

namespace glisson::formats {

/// Takes the cells of a VTK file as they come and makes a volume and a surface of them.
class CellSorter {
 public:
  CellSorter(std::filesystem::path path, long point_count)
      : path_(std::move(path)), point_count_(point_count) {}

  /// @param type VTK's number of the cell type. @throws InputError a point that is not there, a cell that is
  /// neither a linear tetrahedron nor flat.
  void add(long type, const std::vector<long>& points);

  /// Arrays come with a row a cell of the file; each mesh receives the rows of its own cells. Arrays of
  /// another length are left out.
  MixedFile finish(const Points& points, const NamedArrays& point_data, const NamedArrays& cell_data,
                   const NamedArrays& field_data) const;

 private:
  std::filesystem::path path_;
  long point_count_;
  long count_ = 0;
  std::vector<int> tetrahedra_, triangles_;             ///< corners
  std::vector<long> tetrahedron_cell_, triangle_cell_;  ///< the file's cell behind each
};

}  // namespace glisson::formats
