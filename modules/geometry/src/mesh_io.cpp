// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/mesh_io.h"

#include <algorithm>
#include <cstdio>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/liver_size.h"
#include "glisson/geometry/topology.h"
#include "glisson/geometry/vtk_xml_file.h"
#include "mesh_bytes.h"
#include "mesh_io_cells.h"
#include "mesh_io_formats.h"
#include "text_scanner.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

constexpr double kSmallestLiver = 0.08, kLargestLiver = 0.6;  // metres, diagonal of the box
constexpr double kLeastVolume = 200e-6, kMostVolume = 8e-3;   // m3, of livers that no one has to doubt
constexpr double kInch = 0.0254;                              // metres

bool is_vtk_format(const std::string& extension) {
  return extension == ".vtk" || extension == ".vtu" || extension == ".vtp";
}

formats::MixedFile read_xml(const fs::path& path) {
  const VtkXmlFile file = read_vtk_xml(path);
  if (file.points.rows() == 0)
    throw InputError(path.string(), "points", "there are none", "Export the mesh anew");
  formats::CellSorter cells(path, file.points.rows());
  for (std::size_t c = 0; c < file.cells.size(); ++c) cells.add(file.cell_types[c], file.cells[c]);
  return cells.finish(file.points, file.point_data, file.cell_data, file.field_data);
}

formats::MixedFile read_vtk(const fs::path& path) {
  return lower_extension(path) == ".vtk" ? formats::read_legacy_vtk(path) : read_xml(path);
}

void require_finite(const Points& vertices, const std::string& name) {
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
    if (!vertices.row(i).allFinite())
      throw InputError(name, "vertex " + std::to_string(i), "a coordinate is not a finite number",
                       "Export the mesh anew");
}

void require_every_node_used(const TetMesh& mesh, const std::string& name) {
  std::vector<char> used(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (int t = 0; t < mesh.tetrahedron_count(); ++t)
    for (int k = 0; k < 4; ++k) used[mesh.tetrahedra(t, k)] = 1;
  const auto free = std::find(used.begin(), used.end(), 0);
  if (free != used.end())
    throw InputError(name, "vertex " + std::to_string(free - used.begin()), "belongs to no tetrahedron",
                     "Remove the vertices that the volume does not use");
}

/// Nothing carries a piece that shares no node with the rest: it would stay behind, or fly off.
void require_one_piece(const TetMesh& mesh, const std::string& name) {
  TriangleMesh joined;  // two triangles join the four corners of each
  joined.vertices = mesh.vertices;
  joined.triangles.resize(2 * mesh.tetrahedra.rows(), 3);
  joined.triangles << mesh.tetrahedra.leftCols<3>(), mesh.tetrahedra.rightCols<3>();
  int pieces = 0;
  connected_components(joined, &pieces);
  if (pieces > 1)
    throw InputError(name, "tetrahedra", "are in " + std::to_string(pieces) + " pieces that share no node",
                     "Merge the vertices that lie in the same place, or leave the loose pieces out");
}

/// Turns a mesh whose every tetrahedron is negative: some programs order the corners the other way round.
void follow_our_orientation(TetMesh& mesh) {
  if (mesh.tetrahedron_count() > 0 && tetrahedron_volumes(mesh).maxCoeff() < 0.0) orient_tetrahedra(mesh);
}

void require_same_rows(const NamedArrays& arrays, Eigen::Index rows) {
  for (const auto& [name, values] : arrays)
    require(values.rows() == rows, "an array to be written has not one row a point or a cell");
}

}  // namespace

bool is_tetrahedral(const fs::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".msh") return formats::read_msh(path).mesh.tetrahedron_count() > 0;
  if (is_vtk_format(extension)) return read_vtk(path).tets.mesh.tetrahedron_count() > 0;
  if (extension == ".stl" || extension == ".obj" || extension == ".ply") {
    if (!fs::exists(path)) throw FileError(path.string() + ": does not exist. Check the path.");
    return false;
  }
  throw InputError(path.string(), "", "is of no known mesh format (\"" + extension + "\")",
                   "Give .vtu, .vtk, .msh, .vtp, .stl, .obj or .ply");
}

TetFile read_tet_file(const fs::path& path, LengthUnit unit, MeshShape shape) {
  const std::string extension = lower_extension(path), name = path.string();
  TetFile file;
  if (extension == ".msh") {
    file = formats::read_msh(path);
  } else if (extension == ".vtu" || extension == ".vtk") {
    file = std::move(read_vtk(path).tets);
  } else {
    throw InputError(name, "", "is no tetrahedral mesh format (\"" + extension + "\")",
                     "Give .vtu, legacy .vtk or .msh");
  }
  file.mesh.vertices *= metres_per(unit);
  if (file.mesh.vertices.allFinite()) follow_our_orientation(file.mesh);
  if (shape == MeshShape::at_rest)
    check_tetrahedra(file.mesh, name);
  else
    check_connectivity(file.mesh, name);
  require_every_node_used(file.mesh, name);
  if (shape == MeshShape::at_rest) require_one_piece(file.mesh, name);
  return file;
}

TetMesh read_tet_mesh(const fs::path& path, LengthUnit unit, MeshShape shape) {
  return read_tet_file(path, unit, shape).mesh;
}

void write_tet_mesh(const fs::path& path, const TetFile& file, LengthUnit unit) {
  const std::string extension = lower_extension(path);
  if (extension != ".vtu" && extension != ".vtk")
    throw InputError(path.string(), "", "a tetrahedral mesh is not written as \"" + extension + "\"",
                     "Name the file .vtu or .vtk");
  require(file.mesh.vertices.allFinite(), "a mesh to be written has finite coordinates");
  require_same_rows(file.point_data, file.mesh.vertices.rows());
  require_same_rows(file.cell_data, file.mesh.tetrahedra.rows());
  TetFile scaled = file;
  scaled.mesh.vertices /= metres_per(unit);
  write_file_atomically(path, formats::vtk_bytes(path, scaled));
}

void write_tet_mesh(const fs::path& path, const TetMesh& mesh, LengthUnit unit) {
  write_tet_mesh(path, TetFile{mesh, {}, {}, {}}, unit);
}

TriangleFile read_triangle_file(const fs::path& path, LengthUnit unit) {
  const std::string extension = lower_extension(path), name = path.string();
  TriangleFile file;
  if (extension == ".stl") {
    file.mesh = formats::read_stl(path);
  } else if (extension == ".obj") {
    file.mesh = formats::read_obj(path);
  } else if (extension == ".ply") {
    file.mesh = formats::read_ply_surface(path);
  } else if (is_vtk_format(extension)) {
    file = std::move(read_vtk(path).triangles);
  } else {
    throw InputError(name, "", "is no surface format (\"" + extension + "\")",
                     "Give .vtp, legacy .vtk, .stl, .obj or .ply");
  }
  if (file.mesh.triangle_count() == 0)
    throw InputError(name, "triangles", "there are none", "Give a closed surface");
  require_finite(file.mesh.vertices, name);
  file.mesh.vertices *= metres_per(unit);
  return file;
}

TriangleMesh read_triangle_mesh(const fs::path& path, LengthUnit unit) {
  return read_triangle_file(path, unit).mesh;
}

void write_triangle_mesh(const fs::path& path, const TriangleFile& file, LengthUnit unit) {
  const std::string extension = lower_extension(path);
  require(file.mesh.vertices.allFinite(), "a surface to be written has finite coordinates");
  require_same_rows(file.point_data, file.mesh.vertices.rows());
  require_same_rows(file.cell_data, file.mesh.triangles.rows());
  TriangleFile scaled = file;
  scaled.mesh.vertices /= metres_per(unit);
  if (extension == ".stl") {
    write_file_atomically(path, formats::stl_bytes(scaled.mesh));
  } else if (extension == ".obj") {
    write_file_atomically(path, formats::obj_text(scaled.mesh));
  } else if (extension == ".ply") {
    write_file_atomically(path, formats::ply_bytes(scaled.mesh));
  } else if (extension == ".vtp" || extension == ".vtk") {
    write_file_atomically(path, formats::vtk_bytes(path, scaled));
  } else {
    throw InputError(path.string(), "", "a surface is not written as \"" + extension + "\"",
                     "Name the file .vtp, .vtk, .stl, .obj or .ply");
  }
}

void write_triangle_mesh(const fs::path& path, const TriangleMesh& mesh, LengthUnit unit) {
  write_triangle_mesh(path, TriangleFile{mesh, {}, {}, {}}, unit);
}

Points read_node_list(const fs::path& path, LengthUnit unit) {
  const std::string content = mesh_bytes(path);
  TextScanner lines(content, path.string());
  std::vector<double> values;
  std::string_view line;
  for (int number = 1; lines.next_line(line); ++number) {
    line = line.substr(0, line.find('#'));
    TextScanner words(line, path.string());
    std::string_view word = words.token();
    if (word.empty()) continue;
    const std::string field = "line " + std::to_string(number);
    for (int k = 0; k < 3; ++k, word = words.token()) {
      double value = 0.0;
      if (!TextScanner::parse(word, value) || !std::isfinite(value))
        throw InputError(path.string(), field, "does not hold three finite numbers",
                         "Give one node as \"x y z\" a line");
      values.push_back(value);
    }
    if (!word.empty())
      throw InputError(path.string(), field, "holds more than three numbers",
                       "Give one node as \"x y z\" a line");
  }
  if (values.empty())
    throw InputError(path.string(), "", "holds no nodes", "Give one node as \"x y z\" a line");
  return Eigen::Map<const Points>(values.data(), static_cast<Eigen::Index>(values.size() / 3), 3) *
         metres_per(unit);
}

void write_node_list(const fs::path& path, const Points& nodes, LengthUnit unit) {
  std::string text;
  char line[128];
  for (Eigen::Index i = 0; i < nodes.rows(); ++i) {
    const Eigen::Vector3d p = nodes.row(i).transpose() / metres_per(unit);
    std::snprintf(line, sizeof line, "%.9g %.9g %.9g\n", p.x(), p.y(), p.z());
    text += line;
  }
  write_file_atomically(path, text);
}

std::vector<int> read_node_numbers(const fs::path& path, int node_count) {
  const std::string content = mesh_bytes(path);
  TextScanner words(content, path.string());
  std::vector<int> numbers;
  for (std::string_view word = words.token(); !word.empty(); word = words.token()) {
    int number = -1;
    if (!TextScanner::parse(word, number) || number < 0 || number >= node_count)
      throw InputError(
          path.string(), "line " + std::to_string(words.line()),
          "\"" + std::string(word.substr(0, 40)) + "\" is no node of a mesh of " + std::to_string(node_count),
          "Give 0-based node numbers of this mesh");
    numbers.push_back(number);
  }
  if (numbers.empty())
    throw InputError(path.string(), "", "holds no nodes", "Give 0-based node numbers of this mesh");
  return numbers;
}

namespace {
double box_diagonal(const Points& points) {
  return points.rows() == 0 ? 0.0 : (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}
bool plausible(double metres) { return metres >= kSmallestLiver && metres <= kLargestLiver; }
}  // namespace

bool plausible_liver_size(const Points& points) { return plausible(box_diagonal(points)); }

void check_liver_size(const Points& points, LengthUnit unit, const std::string& name) {
  check_liver_size(points, unit, name, {});
}

void check_liver_size(const Points& points, LengthUnit unit, const std::string& name,
                      std::optional<double> volume) {
  const double diagonal = box_diagonal(points);
  if (plausible(diagonal)) return;
  char problem[160];
  std::snprintf(problem, sizeof problem,
                "measures %.4g m across when read in %s, and a liver measures 0.08 to 0.6 m", diagonal,
                unit_code(unit));
  const auto makes_a_liver = [&](double metres) {
    const double scale = metres / metres_per(unit);
    const double held = volume.value_or(0.0) * scale * scale * scale;
    return plausible(scale * diagonal) && (!volume || (held >= kLeastVolume && held <= kMostVolume));
  };
  const bool perhaps_inches = makes_a_liver(kInch);
  std::string remedy = perhaps_inches
                           ? "If it is in inches, enlarge it 25.4 times where it was made, and read it in mm"
                           : "Check what the file holds; no usual unit makes a liver of it";
  for (const LengthUnit other : kLengthUnits)
    if (makes_a_liver(metres_per(other)))
      remedy =
          std::string("Read it in ") + unit_code(other) +
          (perhaps_inches ? "; if it is in inches, enlarge it 25.4 times where it was made, and read it in mm"
                          : "");
  throw InputError(name, "size", problem, remedy);
}

}  // namespace glisson
