// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/segmentation/statistics.h"

namespace glisson::ui {

/// What the list of labels says of one.
struct LabelRow {
  Label label = 0;
  segmentation::LabelFigures figures;  ///< zero: it is empty
  ReviewState review = ReviewState::not_started;
};

/// The liver, its vessels and neighbours, even while they are empty; every other label that has voxels; and
/// the first lesion that is free, to be marked. @param statistics, review may be null.
std::vector<LabelRow> label_rows(const segmentation::LabelStatistics* statistics, const Review* review);

}  // namespace glisson::ui
