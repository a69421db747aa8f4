// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glisson/geometry/mesh_io.h"

/// @file
/// The formats behind mesh_io.h. Coordinates are in the file's unit here; nothing is checked beyond what
/// parsing needs, except that every index is in range.

namespace glisson::formats {

/// What a file says before anyone decides whether it is a volume or a surface.
struct MixedFile {
  TetFile tets;
  TriangleFile triangles;
};

// Through VTK.
/// What VTK would write, in memory: its XML writers crash on a disk that fills up. `path` names the format.
std::string vtk_bytes(const std::filesystem::path& path, const TetFile& file);
std::string vtk_bytes(const std::filesystem::path& path, const TriangleFile& file);

// By our own parsers.
MixedFile read_legacy_vtk(const std::filesystem::path& path);
TetFile read_msh(const std::filesystem::path& path);
TriangleMesh read_stl(const std::filesystem::path& path);
TriangleMesh read_obj(const std::filesystem::path& path);
TriangleMesh read_ply_surface(const std::filesystem::path& path);
std::string stl_bytes(const TriangleMesh& mesh);
std::string obj_text(const TriangleMesh& mesh);
std::string ply_bytes(const TriangleMesh& mesh);

}  // namespace glisson::formats
