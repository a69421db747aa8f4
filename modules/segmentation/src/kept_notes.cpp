// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/kept_notes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
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

/// What a note is about; background: no single structure.
Label structure_of(std::string_view code) {
  const std::string_view of = code.substr(0, code.find('.'));
  if (of == "liver" || of == "seed") return structure::kParenchyma;
  return structure_named(std::string(of)).value_or(structure::kBackground);
}

}  // namespace

bool is_told_of_the_whole(const std::string& note) {
  const std::string_view code = std::string_view(note).substr(0, note.find(' '));
  return code.starts_with("image.") || std::ranges::find(kToldEachTime, code) != kToldEachTime.end();
}

std::vector<std::string> with_kept_notes(const std::vector<std::string>& former, const PartlyAnew& anew,
                                         std::vector<std::string> told) {
  const auto holds = [&](const std::string& note) {
    const std::string_view code = std::string_view(note).substr(0, note.find(' '));
    if (anew.is_whole && is_told_of_the_whole(note)) return false;
    if (!anew.is_kept(structure_of(code)) || (anew.is_answered && anew.is_answered(note))) return false;
    return std::ranges::find(told, note) == told.end();
  };
  std::vector<std::string> all;
  std::ranges::copy_if(former, std::back_inserter(all), holds);
  std::ranges::move(told, std::back_inserter(all));
  return all;
}

bool is_answered(const std::string& note, const Eigen::AlignedBox3d& region, const Seeds& seeds,
                 const std::vector<std::string>& told) {
  const std::string code = note.substr(0, note.find(' '));
  if (code == "liver.cut_by_region") return true;
  const Points* clicks = code == "seed.not_liver_taken"                 ? &seeds.background
                         : code.starts_with("seed.")                    ? &seeds.liver
                         : code == "portal_vein.click_without_effect"   ? &seeds.portal_vein
                         : code == "hepatic_veins.click_without_effect" ? &seeds.hepatic_veins
                                                                        : nullptr;
  if (clicks == nullptr)
    return std::ranges::any_of(told,
                               [&](const std::string& now) { return now.substr(0, now.find(' ')) == code; });
  const int number = code.size() < note.size() ? std::atoi(note.c_str() + code.size()) : 0;
  // One that is not there any more was taken away for it.
  return number < 1 || number > clicks->rows() || region.contains(clicks->row(number - 1).transpose());
}

}  // namespace glisson::segmentation
