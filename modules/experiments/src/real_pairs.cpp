// SPDX-License-Identifier: GPL-3.0-or-later
#include "real_pairs.h"

#include <string>

#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

/// This set marks with zero what is to be used.
Picture inverted(const Picture& mask) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (std::size_t i = 0; i < mask.bytes->size(); i += static_cast<std::size_t>(mask.channels))
    bytes->push_back((*mask.bytes)[i] == 0 ? 255 : 0);
  return {mask.width, mask.height, 1, std::move(bytes)};
}

}  // namespace

RealPair opencas(const fs::path& folder, OpencasPart part) {
  const auto file = [&](const char* name) {
    return folder / (std::string("Stereo_SD_d_complete_22_") + name);
  };
  RealPair pair;
  pair.left = stereo::read_picture(file("IMG_left.bmp"));
  pair.right = stereo::read_picture(file("IMG_right.bmp"));
  pair.mask =
      inverted(stereo::read_picture(file(part == OpencasPart::tissue ? "MASK_left.png" : "MASK_eval.png")));
  pair.rig = stereo::read_text_calibration(folder, pair.left.width, pair.left.height);
  return pair;
}

RealPair heart(const fs::path& folder) {
  RealPair pair;
  pair.left = stereo::read_picture(folder / "f7_dynamic_deint_L_0100.png");
  pair.right = stereo::read_picture(folder / "f7_dynamic_deint_R_0100.png");
  pair.mask = stereo::read_picture(folder / "f7_dynamic_deint_mask_0100.png");
  pair.rig = stereo::read_text_calibration(folder, pair.left.width, pair.left.height);
  return pair;
}

}  // namespace glisson::experiments
