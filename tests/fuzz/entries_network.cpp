// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "entries.h"
#include "glisson/network/label_sheet.h"
#include "glisson/network/mask_sheet.h"
#include "onnx_input.h"
#include "scratch.h"

namespace glisson::fuzz {

void onnx_input(std::string_view bytes) {
  const auto answer = network::reader::onnx_input(bytes);
  must(answer.inputs >= 0, "fewer inputs than none");
  must(answer.rank >= 0 && answer.rank <= static_cast<int>(answer.shape.size()),
       "more sides than there is room");
  must(std::all_of(answer.shape.begin(), answer.shape.begin() + answer.rank,
                   [](std::int32_t side) { return side == -1 || side > 0; }),
       "a side that is no length");
}

void label_sheet(std::string_view bytes) {
  read_file_of("net.json", bytes, [](const std::filesystem::path& path) {
    const network::LabelSheet sheet = network::read_label_sheet(path.parent_path() / "net.onnx");
    must(sheet.window_low_hu < sheet.window_high_hu, "a window that is empty");
    must(!sheet.sd_hu || *sheet.sd_hu > 0.0, "a deviation that is none");
    must(std::all_of(sheet.spacing_mm.begin(), sheet.spacing_mm.end(), [](double mm) { return mm > 0.0; }),
         "a spacing that is none");
    must(std::all_of(sheet.tile.begin(), sheet.tile.end(), [](int side) { return side > 0; }),
         "an empty tile");
    must(sheet.overlap >= 0.0 && sheet.overlap < 1.0, "tiles that never go on");
    must(!sheet.channels.empty(), "no channel");
  });
}

void mask_sheet(std::string_view bytes) {
  read_file_of("net.json", bytes, [](const std::filesystem::path& path) {
    const network::MaskSheet sheet = network::read_mask_sheet(path.parent_path() / "net.onnx");
    must(!sheet.channels.empty() && sheet.is_liver.size() == sheet.channels.size(), "channels of nothing");
    must(sheet.mean.size() == sheet.sd.size(), "means without deviations");
    must(std::all_of(sheet.sd.begin(), sheet.sd.end(), [](double sd) { return sd > 0.0; }),
         "a deviation that is none");
    must(std::all_of(sheet.size.begin(), sheet.size.end(), [](int side) { return side > 0; }),
         "an empty side");
    must(sheet.oldest_seconds > 0.0, "a mask that is never used");
  });
}

}  // namespace glisson::fuzz
