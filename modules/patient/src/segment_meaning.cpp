// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/segment_meaning.h"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "glisson/core/files.h"

namespace glisson {
namespace {

struct Meaning {
  Label label;
  const char* code;  ///< SNOMED CT
  const char* words;
};

// PS3.16 CID 7140 and its like.
constexpr std::array<Meaning, 6> kOrgans = {{{structure::kParenchyma, "10200004", "Liver"},
                                             {structure::kPortalVein, "32764006", "Portal vein"},
                                             {structure::kHepaticVeins, "8993003", "Hepatic vein"},
                                             {structure::kVenaCava, "64131007", "Inferior vena cava"},
                                             {structure::kArtery, "76015000", "Hepatic artery"},
                                             {structure::kGallbladder, "28231008", "Gallbladder"}}};

/// Lesion, mass, neoplasm, cyst, metastasis, hepatocellular carcinoma.
const std::set<std::string>& lesion_codes() {
  static const std::set<std::string> codes = {"52988006",  "4147007",  "108369006",
                                              "441457006", "14799000", "25370001"};
  return codes;
}

std::string part_of(const std::string& text, char between, std::size_t n) {
  std::istringstream stream(text);
  std::string part;
  for (std::size_t i = 0; i <= n; ++i)
    if (!std::getline(stream, part, between)) return {};
  return part;
}

/// Whether a lesion is the liver's, as far as its region says. The codes of lesions are those of any organ;
/// the liver's lobes and segments have codes of their own.
bool is_of_liver(const std::string& terminology) {
  const std::string region = part_of(terminology, '~', 5);
  const std::string code = part_of(region, '^', 1);
  return code.empty() || code == kOrgans.front().code ||
         lower_case(part_of(region, '^', 2)).find("liver") != std::string::npos;
}

std::string entry_of(const std::string& category, const std::string& type, const std::string& region) {
  return "Segmentation category and type - DICOM master list~" + category + '~' + type +
         "~^^~Anatomic codes - DICOM master list~" + region + "~^^";
}

}  // namespace

std::string structure_terminology(Label label) {
  const auto organ = std::ranges::find(kOrgans, label, &Meaning::label);
  if (organ != kOrgans.end())
    return entry_of("SCT^123037004^Anatomical Structure",
                    std::string("SCT^") + organ->code + '^' + organ->words, "^^");
  if (is_lesion(label))
    return entry_of("SCT^49755003^Morphologically Altered Structure", "SCT^52988006^Lesion",
                    "SCT^10200004^Liver");
  return entry_of("SCT^85756007^Tissue", "SCT^85756007^Tissue", "^^");
}

bool is_nameless(const LabelInfo& segment) {
  return segment.name.empty() || segment.name == "label_" + std::to_string(segment.code);
}

bool is_named_otherwise(const LabelInfo& segment) {
  return !is_nameless(segment) && segment.name != structure_name(segment.code);
}

LabelCodes codes_meant(const std::vector<LabelInfo>& segments) {
  LabelCodes codes;
  std::set<Label> taken;
  for (const LabelInfo& segment : segments)
    if (const auto label = structure_named(segment.name)) {
      codes[segment.code] = *label;
      taken.insert(*label);
    }
  Label lesion = structure::kFirstLesion;
  for (const LabelInfo& segment : segments) {
    if (codes.contains(segment.code)) continue;
    const std::string type = part_of(segment.terminology, '~', 2);
    if (part_of(type, '^', 0) != "SCT") continue;
    const std::string code = part_of(type, '^', 1);
    const auto organ = std::ranges::find_if(kOrgans, [&](const Meaning& m) { return code == m.code; });
    if (organ != kOrgans.end()) {
      codes[segment.code] = organ->label;
    } else if (lesion_codes().contains(code) && is_of_liver(segment.terminology)) {
      while (taken.contains(lesion)) ++lesion;
      if (lesion <= structure::kLastLesion) codes[segment.code] = lesion++;
    }
  }
  return codes;
}

}  // namespace glisson
