// SPDX-License-Identifier: GPL-3.0-or-later
#include "landmark_table.h"

#include <algorithm>
#include <cstdio>

namespace glisson::experiments {
namespace {

/// "umbilical_notch" -> "Umbilical notch".
std::string words_of(const char* code) {
  std::string words = code;
  std::replace(words.begin(), words.end(), '_', ' ');
  words.front() = static_cast<char>(words.front() - 'a' + 'A');
  return words;
}

const char* source_words(const engine::LandmarkOrigin& one) {
  if (!one.source) return "unknown";
  switch (*one.source) {
    case atlas::Source::statistics:
      return "from statistics";
    case atlas::Source::image:
      return "found in the CT";
    case atlas::Source::both:
      return one.structure == atlas::Structure::anterior_margin
                 ? "from statistics, drawn to the ridge in the CT"
                 : "from statistics, drawn to the portal vein's umbilical part in the CT";
    case atlas::Source::person:
      break;
  }
  return "a person";
}

const char* decision_words(const engine::LandmarkOrigin& one) {
  if (!one.decision) return "nothing was proposed";
  switch (*one.decision) {
    case atlas::Decision::proposed:
      return "not reviewed";
    case atlas::Decision::accepted:
      return "accepted";
    case atlas::Decision::moved:
      return "moved";
    case atlas::Decision::not_visible:
      break;
  }
  return "not visible";
}

}  // namespace

ReportTable landmark_table(const std::vector<engine::LandmarkOrigin>& landmarks) {
  ReportTable table{"Landmarks", "Where they come from, and what a person made of the proposals.", {}};
  table.heads = {"Landmark", "Source", "Deviation", "Review", "Registration"};
  for (const engine::LandmarkOrigin& one : landmarks) {
    char deviation[32] = "";
    if (one.deviation) std::snprintf(deviation, sizeof deviation, "%.1f mm", 1e3 * *one.deviation);
    table.lines.push_back({words_of(atlas::structure_code(one.structure)), source_words(one), deviation,
                           decision_words(one), one.is_used ? "used" : ""});
  }
  return table;
}

}  // namespace glisson::experiments
