// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_map.h"

namespace glisson {

bool is_lesion(int label) { return label >= structure::kFirstLesion && label <= structure::kLastLesion; }

bool is_other(Label label) { return label >= structure::kFirstOther && label <= structure::kLastOther; }

bool is_liver_tissue(Label label) { return label == structure::kParenchyma || is_lesion(label); }

std::vector<Label> free_labels(Label like, const std::function<bool(Label)>& is_taken) {
  const Label first = is_lesion(like) ? structure::kFirstLesion : structure::kFirstOther;
  const Label last = is_lesion(like) ? structure::kLastLesion : structure::kLastOther;
  std::vector<Label> free;
  for (Label label = first; label <= last; ++label)
    if (!is_taken(label)) free.push_back(label);
  return free;
}

std::optional<Label> structure_named(const std::string& name) {
  for (int label = structure::kBackground; label <= structure::kLastLesion; ++label)
    if (structure_name(static_cast<Label>(label)) == name) return static_cast<Label>(label);
  return std::nullopt;
}

std::string slicer_status(ReviewState state) {
  switch (state) {
    case ReviewState::not_started:
      return "notstarted";
    case ReviewState::in_progress:
      return "inprogress";
    case ReviewState::to_review:
      return "flagged";
    case ReviewState::approved:
      return "completed";
  }
  return "notstarted";
}

ReviewState review_state(const std::string& status) {
  for (const ReviewState state : {ReviewState::in_progress, ReviewState::to_review, ReviewState::approved})
    if (slicer_status(state) == status) return state;
  return ReviewState::not_started;
}

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
  if (is_other(label)) return "other_" + std::to_string(label - structure::kFirstOther + 1);
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
  // Greys, light and dark in turns: what is no part of the liver does not shine.
  if (is_other(label)) return label % 2 == 0 ? std::array{0.62, 0.62, 0.66} : std::array{0.42, 0.42, 0.46};
  return {0.5, 0.5, 0.5};
}

LabelInfo structure_info(Label label) { return {label, structure_name(label), "", structure_colour(label)}; }

}  // namespace glisson
