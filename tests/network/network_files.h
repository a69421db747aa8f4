// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "glisson/core/files.h"
#include "glisson/volume/image.h"
#include "onnx_bytes.h"

namespace glisson::test {

/// A network and its sheet, side by side.
inline std::filesystem::path write_network(const std::filesystem::path& folder, const OnnxNetwork& network,
                                           const std::string& sheet) {
  write_file_atomically(folder / "net.onnx", network.bytes());
  write_file_atomically(folder / "net.json", sheet);
  return folder / "net.onnx";
}

/// Two channels that answer x and 1 - x, so that the second wins below 0.5: pixel by pixel.
inline OnnxNetwork bright_or_dark(const std::vector<long>& shape) {
  return OnnxNetwork(shape).conv(2, 1, 1, {-1.0F, 1.0F}, {1.0F, 0.0F});
}

/// A CT whose Hounsfield units are a function of the voxel.
template <class Function>
Image ct_of(const Eigen::Vector3i& size, const Function& hounsfield) {
  Image image;
  image.grid.size = size;
  auto voxels = std::make_shared<std::vector<std::int16_t>>();
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i)
        voxels->push_back(static_cast<std::int16_t>(hounsfield(Eigen::Vector3i(i, j, k))));
  image.voxels = std::move(voxels);
  return image;
}

}  // namespace glisson::test
