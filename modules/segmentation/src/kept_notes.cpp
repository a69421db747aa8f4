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

/// What a note is about; none: no structure that is found.
std::optional<Label> structure_of(std::string_view code) {
  const std::string_view of = code.substr(0, code.find('.'));
  if (of == "liver" || of == "seed") return structure::kParenchyma;
  return structure_named(std::string(of));
}

}  // namespace

std::vector<std::string> with_kept_notes(const std::vector<std::string>& former,
                                         const std::function<bool(Label)>& is_kept,
                                         std::vector<std::string> told) {
  const auto holds = [&](const std::string& note) {
    const std::string_view code = std::string_view(note).substr(0, note.find(' '));
    const auto label = structure_of(code);
    return label && is_kept(*label) && std::ranges::find(kToldEachTime, code) == kToldEachTime.end() &&
           std::ranges::find(told, note) == told.end();
  };
  std::vector<std::string> all;
  std::ranges::copy_if(former, std::back_inserter(all), holds);
  std::ranges::move(told, std::back_inserter(all));
  return all;
}

}  // namespace glisson::segmentation
