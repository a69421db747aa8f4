// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"
#include "glisson/core/run_context.h"
#include "liver_start.h"

namespace glisson::segmentation {

/// Thin dark sheets: fat between two organs that lie against each other, a seam that the smoothing that parts
/// tissues from noise would close.
/// @param ct not smoothed. @param where is looked at; the rest is 0. @param typical what is found there is
///   tissue without seams: what 95 % of it stays below is no seam.
Mask dark_sheets(const Field& ct, const Mask& where, const Mask& typical);

/// Tissue that falls apart where it narrows.
struct Sides {
  Mask own;    ///< what belongs to the clicks inside
  Mask rival;  ///< bodies that do not
};

/// `tissue` falls into parts at its necks: a part is what drains to one greatest depth (Meyer 1994), united
/// with its neighbour where the neck between them is at least 0.8 times as deep as the shallower of them,
/// unless one has a click inside and the other one outside. The parts with a click inside own every part that
/// they (and what they own) share a face with that is wide for its volume: 0.7 of a half ball's. The left
/// lobe hangs on the right one so, a pancreas or a heart does not.
/// Parts that hold both kinds of clicks, because no neck lies between them, are the inside's.
Cancellable<Sides> part_at_necks(const Field& ct, const Mask& tissue, const LiverSeeds& seeds,
                                 const RunContext& context);

}  // namespace glisson::segmentation
