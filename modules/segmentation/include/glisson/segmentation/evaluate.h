// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/patient/label_map.h"

/// @file
/// Labels against those of an expert, or of a patient whose truth is known. For final comparisons only.

namespace glisson::segmentation {

/// How two masks of one grid agree.
struct Agreement {
  double dice = 0.0;
  double ml = 0.0, truth_ml = 0.0;
};
/// @pre as many voxels in both.
Agreement agreement(const std::vector<std::uint8_t>& mask, const std::vector<std::uint8_t>& truth,
                    double voxel_mm3);

/// "dice_liver" (with everything in it), "dice_<structure>" of every structure that the truth has, "_ml" and
/// "_truth_ml" beside each; vessels once everywhere and once inside the true liver
/// ("dice_portal_vein_inside"); all lesions together ("dice_lesions"). Ways from the trees' roots to their
/// tips (see count_connections()): "tips_<tree>_truth", of them "..._truth_found"; "tips_<tree>", of them
/// "..._true".
/// @pre one grid.
Figures compare_labels(const LabelMap& labels, const LabelMap& truth);

}  // namespace glisson::segmentation
