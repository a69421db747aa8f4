// SPDX-License-Identifier: GPL-3.0-or-later
#include "entries.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/ply_file.h"
#include "glisson/geometry/vtk_xml_file.h"
#include "scratch.h"

namespace glisson::fuzz {
namespace {

void check(const TriangleMesh& mesh) {
  must(mesh.vertices.allFinite(), "a vertex is not finite");
  must(mesh.triangle_count() > 0, "there are no triangles");
  must(mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.vertex_count(),
       "a corner is not there");
}

void mesh(const char* name, std::string_view bytes) {
  read_file_of(name, bytes, [](const std::filesystem::path& path) {
    if (is_tetrahedral(path)) {
      const TetMesh read = read_tet_mesh(path, LengthUnit::millimetre);
      must(read.vertices.allFinite(), "a vertex is not finite");
      must(read.tetrahedra.minCoeff() >= 0 && read.tetrahedra.maxCoeff() < read.vertex_count(),
           "a corner is not there");
      must(read.labels.empty() || static_cast<int>(read.labels.size()) == read.tetrahedron_count(),
           "labels do not fit");
    } else if (path.extension() != ".msh") {
      check(read_triangle_mesh(path, LengthUnit::millimetre));
    }
  });
}

}  // namespace

void vtk_xml(std::string_view bytes) {
  try {
    const VtkXmlFile file = parse_vtk_xml(bytes, "a.vtu");
    must(file.cells.size() == file.cell_types.size(), "cells without a type");
    for (const auto& cell : file.cells)
      for (const long point : cell) must(point >= 0 && point < file.points.rows(), "a point is not there");
    for (const auto& [name, values] : file.point_data)
      must(values.rows() == file.points.rows(), "rows are not points");
    for (const auto& [name, values] : file.cell_data)
      must(values.rows() == static_cast<Eigen::Index>(file.cells.size()), "rows are not cells");
  } catch (const InputError& error) {
    must(!error.remedy().empty(), "refused without a remedy");
    return;
  }
  mesh("a.vtu", bytes);
}
void legacy_vtk(std::string_view bytes) { mesh("a.vtk", bytes); }
void msh(std::string_view bytes) { mesh("a.msh", bytes); }
void ply(std::string_view bytes) { mesh("a.ply", bytes); }
void stl(std::string_view bytes) { mesh("a.stl", bytes); }
void obj(std::string_view bytes) { mesh("a.obj", bytes); }
void node_list(std::string_view bytes) {
  read_file_of("a.txt", bytes, [](const std::filesystem::path& path) {
    must(read_node_list(path, LengthUnit::millimetre).allFinite(), "a node is not finite");
  });
  read_file_of("a.txt", bytes, [](const std::filesystem::path& path) {
    for (const int node : read_node_numbers(path, 100)) must(node >= 0 && node < 100, "a node is not there");
  });
}

}  // namespace glisson::fuzz
