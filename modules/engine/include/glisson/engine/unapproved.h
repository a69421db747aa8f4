// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "glisson/engine/case_state.h"

namespace glisson::engine {

/// The labels that models are built from and that nobody has approved, by how far a person has come with
/// each; ascending. Empty without labels.
std::map<ReviewState, std::vector<Label>> unapproved_labels(const CaseState& state);

/// The same as notes: "label.not_started portal_vein", "label.in_progress ...", "label.to_review ...".
std::vector<std::string> unapproved_notes(const CaseState& state);

}  // namespace glisson::engine
