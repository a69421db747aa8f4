// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "glisson/core/run_context.h"
#include "glisson/stereo/density.h"
#include "glisson/stereo/faults.h"
#include "glisson/stereo/labelling.h"
#include "glisson/stereo/reconstruct.h"

namespace glisson::stereo {

/// One moment of the laparoscope, with what may be used of it and what the operator clicked on it.
struct PairInput {
  StereoFrame frame;
  StereoRig rig;
  Picture mask;     ///< one byte a pixel of the left image, non-zero is to be used; empty: everything
  Regions regions;  ///< of this frame; without any, everything is surface
};

/// Points of a whole pair that are there already.
struct KnownPoints {
  ReconstructOptions options;                  ///< that they were asked for with
  std::shared_ptr<const Reconstructed> whole;  ///< of the same pictures, calibration and mask; null: none
};

/// What a pair shows of the liver.
struct PairCloud {
  std::shared_ptr<const Reconstructed> whole;  ///< the whole pair's points: other regions need no others
  /// The whole's points within the regions, labelled, never empty. Without regions: all, with the whole's
  /// area and density.
  LabelledPart part;
  DensityMap density;          ///< where in the left picture the part's points are missing
  std::string frame_identity;  ///< of the pair
  /// Of the pair. A pair whose points were known is looked at again only where they give cause (rows that are
  /// off, too few points), since it takes a second.
  std::optional<PairCheck> check;
};

/// Stereo pair to labelled cloud. A new pair (none of its points are known) is looked at first and refused
/// for its faults, whatever its points are. Then the points of the whole pair, then those within the regions.
/// Points: SURF or other features, or semi-global matching; ratio and cross check, refinement of each match
/// to a fraction of a pixel, epipolar gate, triangulation, reprojection gate, rejection of outliers, moving
/// least squares with normals. With Method::automatic they are sparse; dense where those are thinner than
/// `least_density_per_cm2`, in the pair or in its regions, and dense ones are more. Once dense, a pair's
/// points (`known`) stay so whatever its regions become: a switch there and back would exchange points under
/// the operator's hand. Deterministic.
/// @param known taken where their options are those that are needed; they are not made again.
/// @throws InputError pictures of another size than the calibration's, mask of another size, regions of
///   another frame or without points, fewer than ten points; where a fault of the pair itself is found
///   (black, lost, swapped, of another scope, ...; see require_sound), that one.
/// @throws PreconditionError options out of range.
Cancellable<PairCloud> reconstruct_pair(const PairInput& input, const ReconstructOptions& options,
                                        const RunContext& context, const KnownPoints& known = {});

}  // namespace glisson::stereo
