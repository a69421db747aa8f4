// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/review.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"

namespace glisson::engine {
namespace {

/// Of labels with a voxel at least. The figures that come with the labels know it without counting.
std::vector<Label> labels_present(const CaseState& state) {
  std::vector<Label> present;
  if (state[part::statistics]) {
    for (const auto& [label, figures] : state[part::statistics]->figures())
      if (figures.voxels > 0) present.push_back(label);
    return present;
  }
  const std::vector<long> histogram = state[part::labels]->voxels.histogram();
  for (std::size_t label = 0; label < histogram.size(); ++label)
    if (histogram[label] > 0) present.push_back(static_cast<Label>(label));
  return present;
}

}  // namespace

std::vector<LabelInfo> reviewed_infos(const CaseState& state) {
  require(state[part::labels] != nullptr, "labels that are named are there");
  std::vector<LabelInfo> infos = state[part::labels]->infos;
  if (const auto& review = state[part::review])
    for (LabelInfo& info : infos)
      if (const auto known = review->find(info.code); known != review->end())
        info.status = slicer_status(known->second);
  return infos;
}

std::map<ReviewState, std::vector<Label>> unapproved_labels(const CaseState& state) {
  std::map<ReviewState, std::vector<Label>> result;
  if (!state[part::labels] || state[part::labels]->voxels.empty()) return result;
  for (const Label label : labels_present(state)) {
    if (label == structure::kBackground || is_other(label)) continue;
    ReviewState review = ReviewState::not_started;
    if (state[part::review])
      if (const auto known = state[part::review]->find(label); known != state[part::review]->end())
        review = known->second;
    if (review != ReviewState::approved) result[review].push_back(label);
  }
  return result;
}

std::vector<std::string> unapproved_notes(const CaseState& state) {
  std::vector<std::string> notes;
  for (const auto& [review, labels] : unapproved_labels(state)) {
    const std::string code = "label." + std::string(code_in(kReviewCodes, review)) + " ";
    for (const Label label : labels) notes.push_back(code + structure_name(label));
  }
  return notes;
}

}  // namespace glisson::engine
