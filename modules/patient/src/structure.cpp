// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_map.h"

namespace glisson {

bool is_lesion(Label label) { return label >= structure::kFirstLesion && label <= structure::kLastLesion; }

std::string structure_name(Label label) {
  switch (label) {
    case structure::kBackground:
      return "background";
    case structure::kParenchyma:
      return "parenchyma";
    case structure::kPortalVein:
      return "portal_vein";
    case structure::kHepaticVeins:
      return "hepatic_veins";
    case structure::kVenaCava:
      return "vena_cava";
    case structure::kArtery:
      return "artery";
    case structure::kGallbladder:
      return "gallbladder";
    default:
      break;
  }
  if (is_lesion(label)) return "lesion_" + std::to_string(label - structure::kFirstLesion + 1);
  return "label_" + std::to_string(label);
}

std::array<double, 3> structure_colour(Label label) {
  switch (label) {
    case structure::kBackground:
      return {0.0, 0.0, 0.0};
    case structure::kParenchyma:
      return {0.80, 0.47, 0.65};
    case structure::kPortalVein:
      return {0.34, 0.71, 0.91};
    case structure::kHepaticVeins:
      return {0.00, 0.45, 0.70};
    case structure::kVenaCava:
      return {0.00, 0.62, 0.45};
    case structure::kArtery:
      return {0.84, 0.37, 0.00};
    case structure::kGallbladder:
      return {0.45, 0.75, 0.35};
    default:
      break;
  }
  static constexpr std::array<std::array<double, 3>, 3> kLesions = {
      {{0.94, 0.89, 0.26}, {0.90, 0.62, 0.00}, {0.95, 0.75, 0.45}}};
  if (is_lesion(label))
    return kLesions[static_cast<std::size_t>(label - structure::kFirstLesion) % kLesions.size()];
  return {0.5, 0.5, 0.5};
}

}  // namespace glisson
