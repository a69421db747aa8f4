// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
}  // namespace part

}  // namespace glisson::engine
