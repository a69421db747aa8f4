// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/network/mask_sheet.h"

#include <algorithm>
#include <cmath>

#include "sheet.h"

namespace glisson::network {
namespace {

void read_colours(Sheet& sheet, MaskSheet& read) {
  const std::string colours = sheet.text("colours").value_or("rgb");
  if (colours != "rgb" && colours != "bgr" && colours != "grey")
    sheet.refuse("colours", "is \"" + colours + "\"", "Write \"rgb\", \"bgr\" or \"grey\"");
  read.colours = colours == "rgb"   ? MaskSheet::Colours::rgb
                 : colours == "bgr" ? MaskSheet::Colours::bgr
                                    : MaskSheet::Colours::grey;
  read.mean = sheet.numbers("mean", -10.0, 10.0).value_or(std::vector<double>());
  read.sd = sheet.numbers("sd", 1e-4, 10.0).value_or(std::vector<double>());
  const auto count = static_cast<std::size_t>(read.colour_count());
  if (!read.mean.empty() || !read.sd.empty())
    for (const auto& [field, values] : {std::pair{"mean", &read.mean}, {"sd", &read.sd}})
      if (values->size() != count)
        sheet.refuse(field, "is not one number for each colour",
                     "Write mean and sd of colours from 0 to 1, or neither");
}

void read_channels(Sheet& sheet, MaskSheet& read) {
  read.channels = sheet.texts("channels").value_or(std::vector<std::string>());
  if (read.channels.empty())
    sheet.refuse("channels", "names no channel",
                 "Write one name for each output channel, as [\"liver\", \"tool\"]");
  read.is_liver.assign(read.channels.size(), 0);
  if (!sheet.has("liver"))
    sheet.refuse("liver", "is missing", "List the channels that may be liver, as [\"liver\"]");
  const std::vector<std::string> livers_named = sheet.texts("liver").value_or(std::vector<std::string>());
  for (const std::string& name : livers_named) {
    bool is_known = false;
    for (std::size_t n = 0; n < read.channels.size(); ++n) {
      if (read.channels[n] != name) continue;
      is_known = true;
      read.is_liver[n] = 1;  // several channels may have one name
    }
    if (!is_known)
      sheet.refuse("liver", "names \"" + name + "\", which is no channel",
                   "Write names that stand in \"channels\"");
  }
  read.threshold = sheet.number("threshold", -1e6, 1e6);
  const auto livers = std::count(read.is_liver.begin(), read.is_liver.end(), char{1});
  const bool are_all_alike = livers == 0 || livers == static_cast<long>(read.is_liver.size());
  if (!read.threshold && are_all_alike)
    sheet.refuse("threshold", "is missing where all channels are liver, or none is",
                 "Say what a score must exceed, as 0.5");
}

}  // namespace

bool MaskSheet::is_not_liver(const float* scores, std::size_t stride) const {
  if (!threshold) {
    std::size_t winner = 0;
    for (std::size_t channel = 1; channel < is_liver.size(); ++channel)
      if (scores[channel * stride] > scores[winner * stride]) winner = channel;
    return is_liver[winner] == 0;
  }
  bool is_other = false, is_seen = false, has_liver = false;
  for (std::size_t channel = 0; channel < is_liver.size(); ++channel) {
    const bool exceeds = scores[channel * stride] > static_cast<float>(*threshold);
    has_liver = has_liver || is_liver[channel] != 0;
    (is_liver[channel] != 0 ? is_seen : is_other) |= exceeds;
  }
  return is_other || (has_liver && !is_seen);
}

MaskSheet read_mask_sheet(const std::filesystem::path& network) {
  constexpr double kMostSide = 4096;
  Sheet sheet(sheet_of(network));
  MaskSheet read;
  read_colours(sheet, read);
  read_channels(sheet, read);
  const auto size = sheet.numbers("size", 8, kMostSide).value_or(std::vector<double>());
  for (const double side : size) {
    if (side != std::floor(side)) sheet.refuse("size", "holds a fraction of a pixel", "Write whole numbers");
    read.size.push_back(static_cast<int>(side));
  }
  if (sheet.has("size") && size.size() != 2)
    sheet.refuse("size", "is not two numbers", "Write [rows, columns]");
  read.oldest_seconds = sheet.number("oldest_seconds", 0.01, 10.0).value_or(read.oldest_seconds);
  sheet.no_other_fields();
  return read;
}

}  // namespace glisson::network
