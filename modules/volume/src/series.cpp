// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/series.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>
#include <tuple>

namespace glisson {
namespace {

constexpr int kFewSlices = 20;
constexpr double kAskew = 0.866;  ///< cosine of 30 degrees

std::string lower(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

template <std::size_t n>
bool has_any(const std::string& text, const std::array<std::string_view, n>& words) {
  return std::ranges::any_of(words,
                             [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

/// Values of ImageType, which backslashes part.
bool has_kind(const DicomSeries& series, std::string_view value) {
  std::size_t from = 0;
  while (from <= series.kind.size()) {
    const std::size_t to = std::min(series.kind.find('\\', from), series.kind.size());
    if (std::string_view(series.kind).substr(from, to - from) == value) return true;
    from = to + 1;
  }
  return false;
}

/// Words of a text, so that "art" is not found in "start".
bool has_word(const std::string& text, std::string_view word) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  return false;
}

/// "Delay 70 s" tells how long after the injection an early phase was scanned. A delayed phase's delay is in
/// minutes, or more than 100 s, and a number without a unit may be anything ("delay 3.0 B30f": the slices').
bool tells_a_scan_delay(const std::string& text) {
  static constexpr std::string_view kDelay = "delay", kBetween = " :=";
  const std::size_t word = text.find(kDelay);
  if (word == std::string::npos) return false;
  const std::size_t from = text.find_first_not_of(kBetween, word + kDelay.size());
  if (from == std::string::npos) return false;
  int seconds = 0;
  const auto number = std::from_chars(text.data() + from, text.data() + text.size(), seconds);
  if (number.ec != std::errc() || seconds > 100) return false;
  const std::size_t unit = text.find_first_not_of(' ', static_cast<std::size_t>(number.ptr - text.data()));
  if (unit == std::string::npos || text[unit] != 's') return false;
  return has_word(text.substr(unit), "s") || text.compare(unit, 3, "sec") == 0 ||
         text.compare(unit, 3, "sek") == 0;
}

bool is_reformatted(const DicomSeries& series) {
  for (const char* kind :
       {"MPR", "REFORMATTED", "MIP", "MINIP", "PROJECTION IMAGE", "CSA MPR", "CURVED", "VRT"})
    if (has_kind(series, kind)) return true;
  const std::string text = lower(series.description);
  return has_word(text, "mpr") || has_word(text, "mip") || has_word(text, "vrt") ||
         text.find("reformat") != std::string::npos;
}

bool is_localizer(const DicomSeries& series) {
  const std::string text = lower(series.description);
  static constexpr std::array<std::string_view, 6> kWords = {"localizer", "localiser", "scout",
                                                             "topogram",  "surview",   "scanogram"};
  return has_kind(series, "LOCALIZER") || has_any(text, kWords);
}

/// Smaller is likelier.
int gravity_of(const DicomSeries& series) {
  const std::vector<SeriesDoubt> doubts = doubts_about(series);
  return doubts.empty() ? 0 : 1 + static_cast<int>(doubts.back());
}

int modality_rank(const DicomSeries& series) {
  if (series.modality == "CT") return 0;
  return series.modality == "MR" ? 1 : 2;
}

bool is_of_another_phase(const DicomSeries& series) {
  const SeriesPhase phase = phase_of(series);
  return phase != SeriesPhase::unsaid && phase != SeriesPhase::portal_venous;
}

}  // namespace

std::vector<SeriesDoubt> doubts_about(const DicomSeries& series) {
  if (!series.images) return {SeriesDoubt::no_image};
  std::vector<SeriesDoubt> doubts;
  const auto add = [&](bool is, SeriesDoubt doubt) {
    if (is) doubts.push_back(doubt);
  };
  const bool capture = series.modality == "SC" || series.modality == "OT" ||
                       has_kind(series, "SCREEN SAVE") ||
                       lower(series.description).find("screen save") != std::string::npos;
  // SECONDARY says that a series came after the examination (a second reconstruction does), ORIGINAL that its
  // values were measured all the same.
  add(has_kind(series, "DERIVED") || (has_kind(series, "SECONDARY") && !has_kind(series, "ORIGINAL")),
      SeriesDoubt::derived);
  add(!capture && series.modality != "CT" && series.modality != "MR", SeriesDoubt::other_modality);
  add(series.slices < kFewSlices && series.frames < 2, SeriesDoubt::few_slices);
  add(series.normal.norm() > 0.5 && std::abs(series.normal.z()) < kAskew, SeriesDoubt::not_axial);
  add(is_reformatted(series), SeriesDoubt::reformatted);
  add(capture, SeriesDoubt::screenshot);
  add(is_localizer(series), SeriesDoubt::localizer);
  add(series.frames > 1, SeriesDoubt::frames);
  add(series.picture.values > 0 && series.picture.values <= 2, SeriesDoubt::mask);
  return doubts;
}

bool can_be_read(const DicomSeries& series) {
  return series.images && series.slices > 1 && series.frames < 2;
}

SeriesPhase phase_of(const DicomSeries& series) {
  const std::string text = lower(series.description + " " + series.protocol);
  const auto any = [&](const auto&... words) { return (has_word(text, words) || ...); };
  static constexpr std::array<std::string_view, 5> kPortal = {"portal", "porto", "pv phase", "venous",
                                                              "veneu"};
  static constexpr std::array<std::string_view, 2> kVenous = {"ven\xc3\xb6s", "venoes"};
  static constexpr std::array<std::string_view, 4> kDelayed = {"delay", "sp\xc3\xa4t", "spaet", "tardi"};
  static constexpr std::array<std::string_view, 2> kArterial = {"arteri", "art\xc3\xa9ri"};
  // "native" stands in "alternative", too; "nativphase" is one word.
  static constexpr std::array<std::string_view, 4> kNative = {"nativphase", "unenhanced", "non-contrast",
                                                              "sans injection"};
  if (has_any(text, kDelayed) && !tells_a_scan_delay(text)) return SeriesPhase::delayed;
  if (has_any(text, kPortal) || has_any(text, kVenous) || any("pv", "pvp", "ven"))
    return SeriesPhase::portal_venous;
  if (has_any(text, kArterial) || any("art", "hap")) return SeriesPhase::arterial;
  if (has_any(text, kNative) || any("native", "nativ", "nc", "w/o", "without contrast", "ohne km"))
    return SeriesPhase::native;
  return SeriesPhase::unsaid;
}

void sort_by_likelihood(std::vector<DicomSeries>& all) {
  const auto key = [](const DicomSeries& s) {
    const double thickness = s.gap_mm > 0.0 ? s.gap_mm : s.thickness_mm > 0.0 ? s.thickness_mm : 1e3;
    return std::tuple(gravity_of(s), modality_rank(s), is_of_another_phase(s), -s.slices, thickness,
                      s.number.size(), s.number, s.uid);
  };
  std::ranges::stable_sort(all, {}, key);
}

}  // namespace glisson
