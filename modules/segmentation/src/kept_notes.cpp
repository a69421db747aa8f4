// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/kept_notes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace glisson::segmentation {
namespace {

/// Told of all labels by each report, whatever was found anew.
constexpr std::array<std::string_view, 6> kToldEachTime = {"liver.cut_off",
                                                           "liver.small",
                                                           "liver.large",
                                                           "liver.perhaps_mirrored",
                                                           "hepatic_veins.hold_cava",
                                                           "hepatic_veins.beside_cava"};

bool is_told_each_time(std::string_view code) {
  return code.starts_with("image.") || std::ranges::find(kToldEachTime, code) != kToldEachTime.end();
}

/// What a note is about; background: no single structure.
Label structure_of(std::string_view code) {
  const std::string_view of = code.substr(0, code.find('.'));
  if (of == "liver" || of == "seed") return structure::kParenchyma;
  return structure_named(std::string(of)).value_or(structure::kBackground);
}

}  // namespace

std::vector<std::string> with_kept_notes(const std::vector<std::string>& former, const PartlyAnew& anew,
                                         std::vector<std::string> told) {
  const auto holds = [&](const std::string& note) {
    const std::string_view code = std::string_view(note).substr(0, note.find(' '));
    if (anew.is_whole && is_told_each_time(code)) return false;
    if (!anew.is_kept(structure_of(code)) || (anew.is_answered && anew.is_answered(note))) return false;
    return std::ranges::find(told, note) == told.end();
  };
  std::vector<std::string> all;
  std::ranges::copy_if(former, std::back_inserter(all), holds);
  std::ranges::move(told, std::back_inserter(all));
  return all;
}

}  // namespace glisson::segmentation
