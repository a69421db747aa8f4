// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "glisson/volume/io.h"

namespace glisson::test {

/// A CT of 128 mm that is quickly read and about which nothing is odd; what it shows is nothing.
inline void write_plain_ct(const std::filesystem::path& path) {
  Image image;
  image.grid.size = {32, 32, 32};
  image.grid.spacing_mm = {4.0, 4.0, 4.0};
  auto voxels = std::make_shared<std::vector<std::int16_t>>(32UL * 32 * 32);
  for (std::size_t n = 0; n < voxels->size(); ++n)
    (*voxels)[n] = static_cast<std::int16_t>((n * 7919) % 1100) - 1000;
  image.voxels = voxels;
  write_image(path, image);
}

}  // namespace glisson::test
