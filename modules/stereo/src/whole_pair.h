// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/run_context.h"
#include "glisson/stereo/reconstruct.h"

namespace glisson::stereo {

/// What refusals for too few points are of; those for other reasons name what they are of.
inline constexpr const char* kPair = "stereo pair";
/// Rectified rows up to which matches are looked for, before they are refined, pixels.
double band_rows(const ReconstructOptions& options);

/// The points of a whole pair, all surface, by `options.method`. See reconstruct_pair, the door to it.
/// @param mask empty, or one byte a pixel of the left image: non-zero is to be used.
/// @throws InputError images of another size than the calibration's, mask of another size, left and right
///   swapped or one picture twice, fewer than ten points.
/// @throws PreconditionError options out of range.
Cancellable<Reconstructed> reconstruct_whole(const Picture& left, const Picture& right, const StereoRig& rig,
                                             const Picture& mask, const ReconstructOptions& options,
                                             const RunContext& context);

}  // namespace glisson::stereo
