// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <string>

#include "glisson/volume/dicom_segmentation.h"

namespace glisson {

bool has_dicom_mark(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  char mark[4] = {};
  stream.seekg(128);
  stream.read(mark, 4);
  return stream.gcount() == 4 && std::string(mark, 4) == "DICM";
}

}  // namespace glisson
