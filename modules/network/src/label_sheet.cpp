// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/network/label_sheet.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "sheet.h"

namespace glisson::network {
namespace {

constexpr double kFarHu = 100000.0;

void read_window(Sheet& sheet, LabelSheet& read) {
  const auto window = sheet.numbers("window_hu", -kFarHu, kFarHu);
  if (!window || window->size() != 2 || (*window)[0] >= (*window)[1])
    sheet.refuse("window_hu", "is not two numbers, the lower first",
                 "Write the Hounsfield units that the network was trained on, as [-160, 240]");
  read.window_low_hu = (*window)[0];
  read.window_high_hu = (*window)[1];
  read.mean_hu = sheet.number("mean_hu", -kFarHu, kFarHu);
  read.sd_hu = sheet.number("sd_hu", 1e-3, kFarHu);
  if (read.mean_hu.has_value() != read.sd_hu.has_value())
    sheet.refuse(read.mean_hu ? "sd_hu" : "mean_hu", "is missing", "Give mean_hu and sd_hu, or neither");
}

Label channel_label(const Sheet& sheet, const std::string& name) {
  if (name == "lesions") return LabelSheet::kLesions;
  const auto label = structure_named(name);
  if (!label || is_lesion(*label) || is_other(*label))
    sheet.refuse("channels", "names \"" + name + "\", which is no label",
                 "Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder or "
                 "lesions");
  return *label;
}

void read_channels(Sheet& sheet, LabelSheet& read) {
  for (const std::string& name : sheet.texts("channels").value_or(std::vector<std::string>()))
    read.channels.push_back(channel_label(sheet, name));
  const auto is_background = [](Label label) { return label == structure::kBackground; };
  const auto backgrounds = std::count_if(read.channels.begin(), read.channels.end(), is_background);
  if (static_cast<std::size_t>(backgrounds) == read.channels.size())
    sheet.refuse("channels", "names no label",
                 "Write one name for each output channel, as [\"background\", \"parenchyma\"]");
  read.threshold = sheet.number("threshold", -1e6, 1e6);
  if (backgrounds == 0 && !read.threshold)
    sheet.refuse("threshold", "is missing where no channel is the background",
                 "Say what a score must exceed, as 0.5");
  read.least_lesion_ml = sheet.number("least_lesion_ml", 0.0, 1000.0).value_or(read.least_lesion_ml);
}

bool are_axes(const std::string& axes) {
  std::string kinds;
  for (const char letter : axes)
    for (const std::string_view pair : {"RL", "AP", "IS"})
      if (pair.find(letter) != std::string_view::npos) kinds += pair.front();
  std::sort(kinds.begin(), kinds.end());
  return axes.size() == 3 && kinds == "AIR";
}

void read_tiles(Sheet& sheet, LabelSheet& read) {
  constexpr double kMostSide = 4096;
  for (const double side : sheet.numbers("tile", 1, kMostSide).value_or(std::vector<double>())) {
    if (side != std::floor(side)) sheet.refuse("tile", "holds a fraction of a voxel", "Write whole numbers");
    read.tile.push_back(static_cast<int>(side));
  }
  if (sheet.has("tile") && read.tile.size() != 2 && read.tile.size() != 3)
    sheet.refuse("tile", "is not two or three numbers", "Write [rows, columns] or [slices, rows, columns]");
  read.spacing_mm = sheet.numbers("spacing_mm", 0.05, 50.0).value_or(std::vector<double>());
  if (sheet.has("spacing_mm") && read.spacing_mm.size() != 2 && read.spacing_mm.size() != 3)
    sheet.refuse("spacing_mm", "is not two or three numbers",
                 "Write [rows, columns] or [slices, rows, columns], in millimetres");
  read.overlap = sheet.number("overlap", 0.0, 0.9).value_or(read.overlap);
  read.axes = sheet.text("axes").value_or(read.axes);
  if (!are_axes(read.axes))
    sheet.refuse("axes", "is \"" + read.axes + "\", not three directions",
                 "Say where slices, rows and columns run to, one each of R or L, A or P, I or S, as \"SPL\"");
}

}  // namespace

bool LabelSheet::finds(Label label) const {
  if (label == structure::kBackground) return false;
  const Label known = is_lesion(label) ? kLesions : label;
  return std::find(channels.begin(), channels.end(), known) != channels.end();
}

LabelSheet read_label_sheet(const std::filesystem::path& network) {
  Sheet sheet(sheet_of(network));
  LabelSheet read;
  read_window(sheet, read);
  read_channels(sheet, read);
  read_tiles(sheet, read);
  sheet.no_other_fields();
  return read;
}

}  // namespace glisson::network
