// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "glisson/engine/case_state.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {

/// What the labels are called, with how far a person has come with each. @pre the state has labels.
std::vector<LabelInfo> reviewed_infos(const CaseState& state);

/// The labels that models are built from and that nobody has approved, by how far a person has come with
/// each; ascending. Empty without labels.
std::map<ReviewState, std::vector<Label>> unapproved_labels(const CaseState& state);

/// The same as notes: "label.not_started portal_vein", "label.in_progress ...", "label.to_review ...".
std::vector<std::string> unapproved_notes(const CaseState& state);

}  // namespace glisson::engine
