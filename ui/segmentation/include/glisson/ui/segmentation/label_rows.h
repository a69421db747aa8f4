// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
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

/// The liver, its vessels and neighbours, even while they are empty; every other label that has voxels; the
/// first lesion that is free, to be marked; and the label that is worked on, whatever became of its voxels.
/// @param statistics, review may be null. @param worked_on background: none.
std::vector<LabelRow> label_rows(const segmentation::LabelStatistics* statistics, const Review* review,
                                 Label worked_on = structure::kBackground);

/// "104 ± 12 HU"; without a unit where the image is no CT.
QString intensity_text(const segmentation::LabelFigures& figures, bool hounsfield);

}  // namespace glisson::ui
