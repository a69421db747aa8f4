// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/patient/label_map.h"

/// @file
/// A lesion is one place: how far it is known and what supports it there is judged at its middle, and its
/// size is that of all its voxels. Neither is true of two metastases under one label.

namespace glisson {

/// Closer than this two pieces are one lesion: what is said at their middle is true of both. To a voxel.
inline constexpr double kOneLesionMm = 5.0;

/// How many voxels each piece of a lesion has, the largest first. Pieces lie more than kOneLesionMm apart,
/// and further than two thick slices that whoever drew them left out. Empty: no voxel has the label.
std::vector<long> lesion_pieces(const LabelVolume& labels, Label lesion);

/// A label that was in pieces.
struct LesionSplit {
  Label lesion = 0;           ///< it keeps the largest piece
  std::vector<Label> others;  ///< the labels of the others, the largest first
  long left = 0;              ///< pieces that stayed with it, because no label is free: the smallest
};

/// Gives each piece of each lesion (as above) a label of its own: files of others often hold all tumours
/// under one number. Names and colours of the new ones are Glisson's, their terminology is the lesion's.
/// @return those that were in pieces, by label.
std::vector<LesionSplit> split_lesions(LabelMap& labels);

}  // namespace glisson
