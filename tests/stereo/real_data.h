// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <filesystem>
#include <sstream>

#include "data_folder.h"
#include "glisson/core/files.h"
#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/picture.h"

/// Reads what the public stereo data sets hold: see shared/data/README.md. Tests skip where it is absent.
namespace real_data {

inline std::vector<double> numbers(const std::filesystem::path& path) {
  std::istringstream text(glisson::read_file(path));
  std::vector<double> values;
  for (double value; text >> value;) values.push_back(value);
  return values;
}

inline glisson::Camera camera(const std::filesystem::path& intrinsics,
                              const std::filesystem::path& distortion, int width, int height) {
  glisson::Camera result;
  result.width = width;
  result.height = height;
  const std::vector<double> m = numbers(intrinsics), d = numbers(distortion);
  for (int i = 0; i < 9; ++i) result.matrix(i / 3, i % 3) = m[static_cast<std::size_t>(i)];
  for (std::size_t i = 0; i < 5 && i < d.size(); ++i) result.distortion[static_cast<Eigen::Index>(i)] = d[i];
  return result;
}

/// @param right_from_left 4 x 4, millimetres.
inline void set_transform(glisson::StereoRig& rig, const std::filesystem::path& right_from_left) {
  const std::vector<double> t = numbers(right_from_left);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) rig.right_from_left.rotation(r, c) = t[static_cast<std::size_t>(4 * r + c)];
    rig.right_from_left.translation[r] = 1e-3 * t[static_cast<std::size_t>(4 * r + 3)];
  }
}

/// Binary STL in millimetres, its vertices unmerged.
inline glisson::TriangleMesh stl(const std::filesystem::path& path) {
  const std::string bytes = glisson::read_file(path);
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  glisson::TriangleMesh mesh;
  mesh.vertices.resize(3 * count, 3);
  mesh.triangles.resize(count, 3);
  for (std::uint32_t t = 0; t < count; ++t) {
    float values[12];
    std::memcpy(values, bytes.data() + 84 + 50 * static_cast<std::size_t>(t), sizeof values);
    for (std::uint32_t k = 0; k < 9; ++k)
      mesh.vertices(3 * t + k / 3, k % 3) = 1e-3 * static_cast<double>(values[3 + k]);
    mesh.triangles.row(t) << static_cast<int>(3 * t), static_cast<int>(3 * t + 1),
        static_cast<int>(3 * t + 2);
  }
  return mesh;
}

/// The sets mark with zero what is to be used; we mark it with non-zero.
inline glisson::Picture inverted(const glisson::Picture& mask) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (std::size_t i = 0; i < mask.bytes->size(); i += static_cast<std::size_t>(mask.channels))
    bytes->push_back((*mask.bytes)[i] == 0 ? 255 : 0);
  return {mask.width, mask.height, 1, std::move(bytes)};
}

}  // namespace real_data
