// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "glisson/patient/label_map.h"
#include "glisson/segmentation/correct_around.h"
#include "glisson/segmentation/segment.h"
#include "glisson/volume/image.h"

namespace glisson::insilico {

/// How much somebody clicks.
struct LaypersonOptions {
  int inside = 5, outside = 5;  ///< clicks
  /// A click in the inner half of every lesion from this size on, ml.
  double least_lesion_ml = 1e9;
  /// Lesions are drawn instead: across the longest diameter of the axial slice that shows most of them, each
  /// end off by 5 % of it (standard deviation, along each axis of the slice).
  bool draws_lesions = false;
  std::uint64_t seed = 1;
  /// @throws InputError naming the option.
  void validate() const;
};

/// An expert who gave all tumours one label is told them apart: each body becomes a lesion of its own, the
/// largest first. Bodies below `least_ml`, smaller than a click is worth, become one lesion together.
void split_lesions(LabelMap& truth, double least_ml);

/// What somebody clicks who has seen livers but no segmentation program: random places well inside what an
/// eye would call liver (tumours and vessels included, 8 mm from its border, 30 mm apart), and random places
/// in soft tissue 8 to 40 mm beside it (25 mm apart). The places are never derived from a result.
/// @param truth of the CT, on its grid. @throws InputError options; when it holds no liver.
segmentation::Seeds click_as_layperson(const Image& ct, const LabelMap& truth,
                                       const LaypersonOptions& options);

/// Where somebody who compares the labels with the CT clicks next: in the middle of what is most deeply wrong
/// of the liver, off by 2 mm (standard deviation, along each axis) but on the side that is meant. Unlike the
/// clicks above this one comes of a result: that is what a correction is.
/// @return empty where nothing is wrong. @throws InputError labels on another grid than the truth.
std::optional<segmentation::Click> correct_as_layperson(const LabelMap& truth, const LabelMap& labels,
                                                        std::uint64_t seed);

}  // namespace glisson::insilico
