// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/segmentation/segment.h"
#include "glisson/segmentation/statistics.h"
#include "glisson/volume/label_volume.h"

namespace glisson::ui {

/// One seed of a segmentation::Seeds: which structure's, and its row there. The liver's seeds go by
/// structure::kParenchyma, those that say "not liver" by structure::kBackground.
struct SeedEntry {
  Label structure = 0;
  int row = 0;
  Eigen::Vector3d p_in_ct = Eigen::Vector3d::Zero();  ///< metres
  double diameter_mm = 0.0;                           ///< a lesion's, as drawn; 0: not drawn
};

/// All seeds, liver first, in the order of their structures.
std::vector<SeedEntry> list_seeds(const segmentation::Seeds& seeds);
/// Appends one. Lesions keep their numbers: those before a new one that have no seeds are empty lists.
/// @throws PreconditionError for a structure that has no seeds.
void add_seed(segmentation::Seeds& seeds, Label structure, const Eigen::Vector3d& p_in_ct);
/// How wide a lesion is. @pre it has a seed.
void set_diameter(segmentation::Seeds& seeds, Label lesion, double diameter_mm);
/// Takes one away. A lesion that loses its last seed leaves an empty list, unless it is the last lesion: the
/// numbers of the others are those of their labels.
void remove_seed(segmentation::Seeds& seeds, const SeedEntry& entry);
int count_seeds(const segmentation::Seeds& seeds, Label structure);

/// Lesions that have seeds, and the first number that is free among them and among the labels that have
/// voxels: what a hand has painted is not the lesion that is clicked next. @param statistics may be null.
std::set<Label> lesions_to_seed(const segmentation::Seeds& seeds,
                                const segmentation::LabelStatistics* statistics);

}  // namespace glisson::ui
