// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/geometry/mesh_io.h"

namespace glisson {

/// What a .vtu or .vtp file holds, in the file's unit. Pieces are joined.
struct VtkXmlFile {
  Points points;
  std::vector<int> cell_types;           ///< VTK's numbers (vtkCellType.h)
  std::vector<std::vector<long>> cells;  ///< the points of each, all of them there
  NamedArrays point_data, cell_data;     ///< a row a point, a row a cell
  NamedArrays field_data;
};

/// Parses VTK's XML files of unstructured grids and polygons (VTK file formats, versions 0.1 to 2.x): ascii,
/// base64 or raw, in place or appended, either endianness, plain or packed by zlib. A strict parser of our
/// own: VTK's crashes or hangs on counts that cannot be, and this one is given every case and every foreign
/// mesh. It trusts no count beyond what the file's size allows, and takes neither document types nor entities
/// of the file's own. Arrays of text are left out.
/// @param name stands in messages. @throws InputError naming the element or array, or the line.
VtkXmlFile parse_vtk_xml(std::string_view content, const std::string& name);
/// @throws FileError, InputError.
VtkXmlFile read_vtk_xml(const std::filesystem::path& path);

}  // namespace glisson
