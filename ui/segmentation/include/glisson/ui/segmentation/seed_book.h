// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/segmentation/segment.h"
#include "glisson/volume/label_volume.h"

namespace glisson::ui {

/// One seed of a segmentation::Seeds: which structure's, and its row there. The liver's seeds go by
/// structure::kParenchyma, those that say "not liver" by structure::kBackground.
struct SeedEntry {
  Label structure = 0;
  int row = 0;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();  ///< metres
};

/// All seeds, liver first, in the order of their structures.
std::vector<SeedEntry> list_seeds(const segmentation::Seeds& seeds);
/// Appends one. A lesion beyond the last one makes a new lesion. @throws PreconditionError for a structure
/// that has no seeds.
void add_seed(segmentation::Seeds& seeds, Label structure, const Eigen::Vector3d& p_in_ct);
/// Takes one away; a lesion that loses its last seed goes, and those behind it move up.
void remove_seed(segmentation::Seeds& seeds, const SeedEntry& entry);
int count_seeds(const segmentation::Seeds& seeds, Label structure);

}  // namespace glisson::ui
