// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cstdio>
#include <cstring>

#include "glisson/core/error.h"
#include "glisson/geometry/ply_file.h"
#include "glisson/geometry/topology.h"
#include "mesh_bytes.h"
#include "mesh_io_formats.h"
#include "text_scanner.h"

namespace glisson::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read as memory is");

constexpr std::size_t kStlHeader = 84, kStlFacet = 50;

TriangleMesh mesh_of(const std::vector<double>& coordinates, const std::vector<int>& corners) {
  TriangleMesh mesh;
  mesh.vertices =
      Eigen::Map<const Points>(coordinates.data(), static_cast<Eigen::Index>(coordinates.size() / 3), 3);
  mesh.triangles =
      Eigen::Map<const Triangles>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
  return mesh;
}

void add_fan(const std::vector<int>& polygon, std::vector<int>& corners) {
  for (std::size_t k = 2; k < polygon.size(); ++k)
    corners.insert(corners.end(), {polygon[0], polygon[k - 1], polygon[k]});
}

TriangleMesh soup(const std::vector<double>& coordinates) {
  std::vector<int> corners(coordinates.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<int>(i);
  TriangleMesh facets = mesh_of(coordinates, corners);
  // What is no number has no place in an order: every vertex would be held against every other. It is refused
  // as such by whoever asked.
  return facets.vertices.allFinite() ? merge_vertices(facets, 0.0) : facets;
}

TriangleMesh read_binary_stl(const std::string& content, std::uint32_t facets) {
  std::vector<double> coordinates;
  coordinates.reserve(facets * 9UL);
  for (std::size_t f = 0; f < facets; ++f) {
    float values[9];
    std::memcpy(values, content.data() + kStlHeader + f * kStlFacet + 12, sizeof values);
    coordinates.insert(coordinates.end(), values, values + 9);
  }
  return soup(coordinates);
}

}  // namespace

TriangleMesh read_stl(const std::filesystem::path& path) {
  const std::string content = mesh_bytes(path);
  // Binary files may begin with "solid" too: their size gives them away.
  if (content.size() >= kStlHeader) {
    std::uint32_t facets = 0;
    std::memcpy(&facets, content.data() + 80, sizeof facets);
    if (content.size() == kStlHeader + kStlFacet * facets) {
      check_rows(path.string(), "facets", facets);
      return read_binary_stl(content, facets);
    }
  }
  if (content.rfind("solid", 0) != 0)
    throw InputError(path.string(), "", "is neither a whole binary STL nor an ascii one",
                     "Export the surface anew");
  TextScanner scanner(content, path.string());
  std::vector<double> coordinates;
  bool ended = false;
  for (std::string_view word = scanner.token(); !word.empty(); word = scanner.token()) {
    if (word == "facet") check_rows(path.string(), "facets", static_cast<double>(coordinates.size()) / 9.0);
    if (word == "vertex")
      for (int k = 0; k < 3; ++k) coordinates.push_back(scanner.number());
    ended = word == "endsolid" || (ended && word != "solid");
  }
  if (!ended || coordinates.size() % 9 != 0) scanner.fail("the file ends inside a facet");
  return soup(coordinates);
}

TriangleMesh read_obj(const std::filesystem::path& path) {
  const std::string content = mesh_bytes(path);
  TextScanner lines(content, path.string());
  std::vector<double> coordinates;
  std::vector<int> corners;
  std::string_view line;
  for (int number = 1; lines.next_line(line); ++number) {
    TextScanner words(line, path.string());
    const std::string_view key = words.token();
    const auto fail = [&](const std::string& problem) {
      throw InputError(path.string(), "line " + std::to_string(number), problem, "Export the surface anew");
    };
    check_rows(path.string(), "line " + std::to_string(number),
               static_cast<double>(std::max(coordinates.size(), corners.size())) / 3.0);
    if (key == "v") {
      for (int k = 0; k < 3; ++k) {
        double value = 0.0;
        if (!TextScanner::parse(words.token(), value)) fail("a vertex needs three numbers");
        coordinates.push_back(value);
      }
    } else if (key == "f") {
      const long count = static_cast<long>(coordinates.size() / 3);
      std::vector<int> polygon;
      for (std::string_view word = words.token(); !word.empty(); word = words.token()) {
        long index = 0;
        if (!TextScanner::parse(word.substr(0, word.find('/')), index)) fail("a face names no vertex number");
        index = index < 0 ? count + index : index - 1;  // negative ones count back from the last vertex
        if (index < 0 || index >= count) fail("a face names a vertex that is not there");
        polygon.push_back(static_cast<int>(index));
      }
      if (polygon.size() < 3) fail("a face has fewer than three vertices");
      add_fan(polygon, corners);
    }
  }
  return mesh_of(coordinates, corners);
}

TriangleMesh read_ply_surface(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::vector<double> coordinates;
  std::vector<int> corners;
  long vertices = 0;
  for (const PlyElement& element : read_ply(path)) {
    if (element.name == "vertex") {
      vertices = element.count;
      coordinates.resize(static_cast<std::size_t>(vertices) * 3);
      int axis = 0;
      for (const char* key : {"x", "y", "z"}) {
        const auto column = element.scalars.find(key);
        if (column == element.scalars.end())
          throw InputError(name, "vertex", std::string("has no property \"") + key + "\"",
                           "Export the file anew");
        for (std::size_t i = 0; i < column->second.size(); ++i) coordinates[3 * i + axis] = column->second[i];
        ++axis;
      }
    } else if (element.name == "face") {
      auto lists = element.lists.find("vertex_indices");
      if (lists == element.lists.end()) lists = element.lists.find("vertex_index");
      if (lists == element.lists.end()) continue;
      for (std::size_t f = 0; f < lists->second.size(); ++f) {
        std::vector<int> polygon;
        for (const double index : lists->second[f]) {
          if (!(index >= 0.0 && index < static_cast<double>(vertices)))
            throw InputError(name, "face " + std::to_string(f), "names a vertex that is not there",
                             "Export the file anew");
          polygon.push_back(static_cast<int>(index));
        }
        add_fan(polygon, corners);
      }
    }
  }
  return mesh_of(coordinates, corners);
}

std::string stl_bytes(const TriangleMesh& mesh) {
  std::string bytes = "binary STL";
  bytes.resize(80, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(mesh.triangle_count()));
  const Points normals = triangle_normals(mesh);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, static_cast<float>(normals(t, axis)));
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        append_little_endian(bytes, static_cast<float>(mesh.vertices(mesh.triangles(t, k), axis)));
    append_little_endian(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string obj_text(const TriangleMesh& mesh) {
  std::string text;
  char line[128];
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", mesh.vertices(i, 0), mesh.vertices(i, 1),
                  mesh.vertices(i, 2));
    text += line;
  }
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    std::snprintf(line, sizeof line, "f %d %d %d\n", mesh.triangles(t, 0) + 1, mesh.triangles(t, 1) + 1,
                  mesh.triangles(t, 2) + 1);
    text += line;
  }
  return text;
}

std::string ply_bytes(const TriangleMesh& mesh) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.vertex_count()) +
      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
      std::to_string(mesh.triangle_count()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < mesh.vertex_count(); ++i)
    for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, mesh.vertices(i, axis));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    append_little_endian(bytes, std::uint8_t{3});
    for (int k = 0; k < 3; ++k) append_little_endian(bytes, mesh.triangles(t, k));
  }
  return bytes;
}

}  // namespace glisson::formats
