// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/segmentation/correct_around.h"

namespace glisson::segmentation {

/// Where a vessel or a lesion is that the labels leave out, or show wrongly.
struct StructureClick {
  Label structure = structure::kPortalVein;  ///< see grows_around()
  Point<CtFrame> p_in_ct;
  bool operator==(const StructureClick& other) const {
    return structure == other.structure && p_in_ct.xyz == other.p_in_ct.xyz;
  }
};

/// Whether a click on the structure can be followed around it: portal vein, hepatic veins and lesions.
bool grows_around(Label structure);

/// The clicks on such structures that `after` has and `before` has not, in their order. A lesion of which the
/// drawn diameter alone is another counts by its last click.
std::vector<StructureClick> structure_clicks_added(const Seeds& before, const Seeds& after);

/// A branch or a lesion found by segment() in the surroundings of a click alone; all else stays, voxel by
/// voxel. A vessel is followed from the click, 45 mm to each side, and only gains: what the labels have of it
/// stays. A lesion is found anew from all its clicks, and takes the place of all that the labels have of it,
/// wherever that lies. Where nothing is found nothing changes, and a note says so ("portal_vein.not_found",
/// "lesion_2.not_found").
/// @param seeds of a lesion its clicks and diameter are read, the click among them.
/// @param locked neither lose nor gain a voxel.
/// @throws InputError a click outside the image; labels on another grid; a locked structure or liver.
/// @pre grows_around(click.structure)
Cancellable<CorrectedAround> grow_around(const Image& image, const LabelMap& labels, const Seeds& seeds,
                                         const StructureClick& click, const std::vector<Label>& locked,
                                         const RunContext& context);

}  // namespace glisson::segmentation
