// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "level_set.h"
#include "liver_start.h"

namespace glisson::segmentation {

struct LiverContour {
  Field phi;  ///< mm, negative inside
  Tissue parenchyma;
  Mask like;           ///< what looks like liver, anywhere
  Mask own;            ///< what of it is the liver's
  Mask closed_ground;  ///< what was barred, and what the clicks outside own
  Doubtful doubtful;
};

/// Steps: robust statistics at the seeds; a start by parting what looks like liver at its necks and seams
/// (see part_at_necks()); a contour driven by that; new statistics inside and in a rim outside; a second
/// contour driven by their ratio; last rounds that settle half way between the liver and what lies beside it,
/// and follow the liver's thin margins.
/// @param ct denoised. @param barred structures that are known not to be liver (vena cava, gallbladder).
/// @param included structures that are known to be (lesions). @param likely what perhaps is, see
/// find_start().
Cancellable<LiverContour> find_liver(const Field& ct, const PartingView& view, const LiverSeeds& seeds,
                                     const Mask& barred, const Mask& included, const Mask& likely,
                                     const RunContext& context, const ShowContour& show = {});

/// The last rounds again, from a liver to which bodies were added that do not look like it (see
/// with_enclosed()). What lies 5 mm deep in it stays, and what lies 3 mm outside: it had come to rest.
/// @param contour its tissue and what looks like it. @return mm, negative inside, on the grid of `ct`.
Cancellable<Field> settle_liver(const Field& ct, const Mask& whole, const LiverContour& contour,
                                const LiverSeeds& seeds, const Mask& included, const RunContext& context,
                                const ShowContour& show = {});

/// The last rounds again, on finer voxels, from a contour that came to rest on coarser ones of the same
/// image; never farther than 3 mm from it.
/// @param ct denoised, finer. @param from on its own grid. @return on the grid of `ct`.
Cancellable<Field> refine_liver(const Field& ct, const Field& from, const LiverSeeds& seeds,
                                const Mask& barred, const Mask& included, const RunContext& context,
                                const ShowContour& show = {});

}  // namespace glisson::segmentation
