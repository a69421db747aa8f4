// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/kept_notes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "glisson/core/patient_range.h"
#include "part.h"
#include "remarks.h"
#include "same_click.h"

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

std::string_view code_of(std::string_view note) { return note.substr(0, note.find(' ')); }

/// The first value; 0: it is no number.
int number_in(const std::string& note) {
  const std::size_t code = code_of(note).size();
  return code < note.size() ? std::atoi(note.c_str() + code) : 0;
}

/// The clicks among which a note's number counts. Null: it names none.
const Points* clicks_of(std::string_view code, const Seeds& seeds) {
  if (code == "seed.not_liver_taken") return &seeds.background;
  if (code.starts_with("seed.")) return &seeds.liver;
  if (code == "portal_vein.click_without_effect") return &seeds.portal_vein;
  if (code == "hepatic_veins.click_without_effect") return &seeds.hepatic_veins;
  return nullptr;
}

constexpr std::string_view kPlace = " @";

/// "seed.liver_taken 4 vena_cava @..." with the number 3: "seed.liver_taken 3 vena_cava".
std::string renumbered(const std::string& note, Eigen::Index number) {
  const std::size_t code = code_of(note).size();
  const std::size_t rest = std::min(note.find(' ', code + 1), note.size());
  const std::size_t end = note.find(kPlace);
  return note.substr(0, code) + " " + std::to_string(number) +
         (rest < end ? note.substr(rest, end - rest) : "");
}

/// See inside_liver().
double ml_inside(const LabelMap& labels) {
  const std::vector<std::uint8_t> inside = inside_liver(labels);
  return 1e-3 * static_cast<double>(std::ranges::count(inside, 1)) * labels.voxels.grid().voxel_volume_mm3();
}

}  // namespace

std::optional<Point<CtFrame>> place_told(const std::string& note) {
  const std::size_t place = note.find(kPlace);
  if (place == std::string::npos) return {};
  Eigen::Vector3d mm;
  const char *at = note.data() + place + kPlace.size(), *const end = note.data() + note.size();
  for (double& coordinate : mm) {
    const auto [next, failure] = std::from_chars(at, end, coordinate);
    if (failure != std::errc() || !(std::abs(coordinate) < 1e3 * kPatientRange)) return {};
    at = std::min(next + 1, end);  // behind the comma
  }
  return Point<CtFrame>(1e-3 * mm);
}

std::string place_text(const Eigen::Vector3d& p_in_ct) {
  std::string place;
  for (const double metres : p_in_ct) {
    std::array<char, 40> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), 1e3 * metres, std::chars_format::fixed, 4).ptr;
    place += place.empty() ? std::string(kPlace) : ",";
    place.append(text.data(), end);
  }
  return place;
}

std::vector<std::string> with_places(std::vector<std::string> notes, const Seeds& seeds) {
  for (std::string& note : notes) {
    const Points* clicks = clicks_of(code_of(note), seeds);
    const int number = number_in(note);
    if (clicks == nullptr || place_told(note) || number < 1 || number > clicks->rows()) continue;
    note += place_text(clicks->row(number - 1).transpose());
  }
  return notes;
}

std::vector<std::string> with_numbers(const std::vector<std::string>& notes, const Seeds& seeds) {
  std::vector<std::string> numbered;
  for (const std::string& note : notes) {
    std::string now = note;
    const Points* clicks = clicks_of(code_of(note), seeds);
    if (const auto place = place_told(note); clicks != nullptr && place) {
      const Eigen::Index number = click_number(*clicks, place->xyz.transpose());
      if (number > clicks->rows()) continue;
      now = renumbered(note, number);
    }
    if (std::ranges::find(numbered, now) == numbered.end()) numbered.push_back(std::move(now));
  }
  return numbered;
}

bool is_settled(const std::string& note, const LabelMap& labels) {
  const std::string_view code = code_of(note);
  if (code == "liver.small") return ml_inside(labels) >= kSmallLiver;
  if (code == "liver.large") return ml_inside(labels) <= kLargeLiver;
  const auto place = place_told(note);
  const auto voxel = place ? voxel_in(labels.voxels.grid(), std::nullopt, place->xyz) : std::nullopt;
  if (!voxel) return false;
  const Label label = labels.voxels.at(*voxel);
  if (code == "liver.perhaps_more") return label != structure::kBackground;
  if (code == "liver.dark_body") return label != structure::kParenchyma;
  if (code == "seed.not_liver_taken") return !is_in_liver(label);
  return code.starts_with("seed.liver_") && is_in_liver(label);
}

bool is_told_of_the_whole(const std::string& note) {
  const std::string_view code = code_of(note);
  return code.starts_with("image.") || std::ranges::find(kToldEachTime, code) != kToldEachTime.end();
}

std::vector<std::string> with_kept_notes(const std::vector<std::string>& former, const PartlyAnew& anew,
                                         std::vector<std::string> told) {
  const auto holds = [&](const std::string& note) {
    const std::string_view code = code_of(note);
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
  const std::string code(code_of(note));
  if (code == "liver.cut_by_region") return true;
  const Points* clicks = clicks_of(code, seeds);
  if (clicks == nullptr)
    return std::ranges::any_of(told, [&](const std::string& now) { return code_of(now) == code; });
  const int number = number_in(note);
  // One that is not there any more was taken away for it.
  return number < 1 || number > clicks->rows() || region.contains(clicks->row(number - 1).transpose());
}

}  // namespace glisson::segmentation
