// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/self_test.h"

#include <memory>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"

namespace glisson {

void try_volumes() {
  const TemporaryFolder folder;
  Image image;
  image.grid.size = {4, 4, 4};
  image.grid.spacing_mm = {1.0, 1.0, 1.0};
  image.voxels = std::make_shared<std::vector<std::int16_t>>(64, std::int16_t{40});
  write_image(folder.path() / "tried.nrrd", image);
  if (*read_image(folder.path() / "tried.nrrd", RunContext())->voxels != *image.voxels)
    throw FileError("tried.nrrd: a volume reads back differently from what was written. Check the disk.");
}

}  // namespace glisson
