// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/unapproved.h"

namespace glisson::engine {
namespace {

/// Of labels with a voxel at least. The figures that come with the labels know it without counting.
std::vector<Label> labels_present(const CaseState& state) {
  std::vector<Label> present;
  if (state.statistics) {
    for (const auto& [label, figures] : state.statistics->figures())
      if (figures.voxels > 0) present.push_back(label);
    return present;
  }
  const std::vector<long> histogram = state.labels->voxels.histogram();
  for (std::size_t label = 0; label < histogram.size(); ++label)
    if (histogram[label] > 0) present.push_back(static_cast<Label>(label));
  return present;
}

}  // namespace

std::map<ReviewState, std::vector<Label>> unapproved_labels(const CaseState& state) {
  std::map<ReviewState, std::vector<Label>> result;
  if (!state.labels || state.labels->voxels.empty()) return result;
  for (const Label label : labels_present(state)) {
    if (label == structure::kBackground || is_other(label)) continue;
    ReviewState review = ReviewState::not_started;
    if (state.review)
      if (const auto known = state.review->find(label); known != state.review->end()) review = known->second;
    if (review != ReviewState::approved) result[review].push_back(label);
  }
  return result;
}

std::vector<std::string> unapproved_notes(const CaseState& state) {
  std::vector<std::string> notes;
  for (const auto& [review, labels] : unapproved_labels(state)) {
    const std::string code = review == ReviewState::not_started   ? "label.not_started "
                             : review == ReviewState::in_progress ? "label.in_progress "
                                                                  : "label.to_review ";
    for (const Label label : labels) notes.push_back(code + structure_name(label));
  }
  return notes;
}

}  // namespace glisson::engine
