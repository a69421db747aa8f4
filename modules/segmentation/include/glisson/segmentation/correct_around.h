// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/label_map.h"
#include "glisson/segmentation/segment.h"
#include "glisson/volume/image.h"

namespace glisson::segmentation {

/// Where the labels are wrong: liver that they leave out, or what they take for liver and is none.
struct Click {
  Point<CtFrame> p_in_ct;
  bool is_liver = true;
  bool operator==(const Click& other) const {
    return p_in_ct.xyz == other.p_in_ct.xyz && is_liver == other.is_liver;
  }
};

/// The clicks for and against the liver that `after` has and `before` has not, in their order.
std::vector<Click> clicks_added(const Seeds& before, const Seeds& after);

/// The labels after a click, and how far it reached.
struct CorrectedAround {
  LabelMap labels;
  double reach_mm = 0.0;  ///< how far from the click the farthest voxel lies that has changed
  long voxels_changed = 0;
  std::vector<std::string> notes;  ///< as SegmentationReport has them, where the click cannot bind
};

/// The liver's border once more, only around a click, as far as the click says how wrong it is.
///
/// A click that lies d beyond the border shows an error of about that depth: at distance r from it the labels
/// are wrong with the log odds 1 - r / d0, d0 = d + 6 mm, and beyond 2.5 d0 (60 mm at most) they stay. What
/// each voxel shows counts as the log likelihood of what is like the click or the border's right side,
/// against what lies on the other side, the farther from the click the more. Both, each between -1 and 1, are
/// put together with what a border costs in one exact cut (see best_region()), from which the part that holds
/// the click is taken. 4 mm around the click are its side's. What the change cuts off from the other side, or
/// encloses of it, goes with it unless a click lies in it. Vessels, the cava and the gallbladder stay as they
/// are; so does all that is locked.
/// @param seeds of them those for and against the liver: what lies within 4 mm of one stays its side's.
/// @throws InputError a click outside the image; labels on another grid; a locked liver.
Cancellable<CorrectedAround> correct_around(const Image& image, const LabelMap& labels, const Seeds& seeds,
                                            const Click& click, const std::vector<Label>& locked,
                                            const RunContext& context);

}  // namespace glisson::segmentation
