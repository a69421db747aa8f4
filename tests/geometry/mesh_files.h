// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "glisson/core/files.h"
#include "glisson/geometry/topology.h"

namespace glisson::test {

inline TetMesh two_tetrahedra() {
  TetMesh mesh;
  mesh.vertices.resize(5, 3);
  mesh.vertices << 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0.1, 0.1, 0.1234567890123;
  mesh.tetrahedra.resize(2, 4);
  mesh.tetrahedra << 0, 1, 2, 3, 1, 2, 3, 4;
  mesh.labels = {1, 16};
  return mesh;
}

inline TriangleMesh tetrahedron_surface() {
  TetMesh mesh = two_tetrahedra();
  return boundary_surface(mesh).mesh;
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A file of that name and content in a folder of its own; both go with this.
class WrittenFile {
 public:
  WrittenFile(const std::string& name, const std::string& text) : path(folder_.path() / name) {
    write_text(path, text);
  }

 private:
  TemporaryFolder folder_;

 public:
  const std::filesystem::path path;
};

}  // namespace glisson::test
