// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "glisson/core/units.h"
#include "glisson/geometry/mesh.h"

/// @file
/// Meshes on disk. Coordinates are metres in memory and `unit` in the file; nodes keep their order both ways.
/// Named arrays are written and read as they are: whoever fills them says their unit in the name
/// ("displacement_mm", "von_mises_pa"). Writers are atomic and read back what they wrote.

namespace glisson {

/// One row a point, a cell, or of a matrix (field data: `cloud_from_model`, 4 x 4).
using NamedArrays = std::map<std::string, Eigen::MatrixXd>;

/// A tetrahedral mesh with what else its file holds. Arrays of a point or a cell have as many rows as there
/// are vertices or tetrahedra.
struct TetFile {
  TetMesh mesh;  ///< mesh.labels is the cell array "label" ("labels", or gmsh's physical volume)
  NamedArrays point_data, cell_data, field_data;
};

/// A surface with what else its file holds; rows as in TetFile.
struct TriangleFile {
  TriangleMesh mesh;
  NamedArrays point_data, cell_data, field_data;
};

/// Whether a mesh file holds tetrahedra (.vtu, .vtk and .msh are looked into; formats of surfaces never do).
/// @throws FileError missing; InputError unreadable or of no known format.
bool is_tetrahedral(const std::filesystem::path& path);

/// What a mesh's nodes show: the shape at rest, whose tetrahedra all have a volume, or a deformed one.
enum class MeshShape { at_rest, deformed };

/// Reads a tetrahedral mesh: .vtu, legacy .vtk, gmsh .msh (versions 2 and 4, ascii). Cells of lower dimension
/// are left out. A mesh whose every tetrahedron is negatively oriented follows the other convention and is
/// turned.
/// @throws FileError missing; InputError malformed, not finite, other volume cells, some tetrahedra inverted
///   or flat (see check_tetrahedra; of a deformed one they are not asked), nodes that no tetrahedron uses,
///   pieces that share no node (not asked of a deformed one either).
TetFile read_tet_file(const std::filesystem::path& path, LengthUnit unit,
                      MeshShape shape = MeshShape::at_rest);
/// The mesh alone.
TetMesh read_tet_mesh(const std::filesystem::path& path, LengthUnit unit,
                      MeshShape shape = MeshShape::at_rest);

/// Writes .vtu or legacy .vtk by extension; labels as the cell array "label". Atomic, read back.
/// @pre arrays have a row a point, or a row a cell. @throws FileError; InputError for another extension.
void write_tet_mesh(const std::filesystem::path& path, const TetFile& file, LengthUnit unit);
void write_tet_mesh(const std::filesystem::path& path, const TetMesh& mesh, LengthUnit unit);

/// Reads a surface: .vtp, legacy .vtk (polydata, or an unstructured grid of triangles), .stl, .obj, .ply.
/// Polygons are cut into fans. STL's equal vertices are merged; elsewhere nodes stay as they are.
/// @throws FileError missing; InputError malformed, not finite, no triangles, an index out of range.
TriangleFile read_triangle_file(const std::filesystem::path& path, LengthUnit unit);
TriangleMesh read_triangle_mesh(const std::filesystem::path& path, LengthUnit unit);

/// Writes .vtp, legacy .vtk, .stl (binary, single precision), .obj or .ply (binary, double). Only the first
/// two hold arrays; the others drop them. Atomic, read back. @throws FileError; InputError extension.
void write_triangle_mesh(const std::filesystem::path& path, const TriangleFile& file, LengthUnit unit);
void write_triangle_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, LengthUnit unit);

/// Node positions, one "x y z" a line (comments from '#').
/// @throws FileError missing; InputError naming the line: not three finite numbers, or no nodes at all.
Points read_node_list(const std::filesystem::path& path, LengthUnit unit);
void write_node_list(const std::filesystem::path& path, const Points& nodes, LengthUnit unit);
/// 0-based node numbers, separated by white space. @param node_count numbers must lie below it.
/// @throws FileError; InputError naming the line.
std::vector<int> read_node_numbers(const std::filesystem::path& path, int node_count);

/// Whether points can be a liver: the diagonal of their box lies within 0.08 to 0.6 m.
bool plausible_liver_size(const Points& points);
/// @param unit in which `name` was read.
/// @throws InputError when it cannot be a liver; the remedy names the unit that would fit, if one does.
void check_liver_size(const Points& points, LengthUnit unit, const std::string& name);

}  // namespace glisson
