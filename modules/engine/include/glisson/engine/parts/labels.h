// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/editing/history.h"
#include "glisson/engine/case_state.h"
#include "glisson/patient/label_map.h"
#include "glisson/segmentation/statistics.h"

namespace glisson::engine {

namespace part {
/// The segmentation.
extern const PartOf<LabelMap> labels;
/// With the labels come their steps, and their figures on the image.
extern const PartOf<editing::History> history;
extern const PartOf<segmentation::LabelStatistics> statistics;
/// And what was told of them when they were found or imported, codes with values ("liver.perhaps_more 385");
/// it stays while a hand edits them, and goes back and forth with their steps. Notes on a click hold its
/// place (see segmentation::with_places()).
extern const PartOf<std::vector<std::string>> label_notes;
}  // namespace part

/// part::label_notes; empty where nothing was told, or in cases of before.
std::vector<std::string> kept_notes(const CaseState& state);
/// The same for people: clicks by the numbers that they have among the case's seeds now; what was told of
/// those that were taken away is left out.
std::vector<std::string> told_of_labels(const CaseState& state);

}  // namespace glisson::engine
