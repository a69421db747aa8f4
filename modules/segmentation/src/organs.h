// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"
#include "tissue.h"

namespace glisson::segmentation {

/// A compact body (lesion, gallbladder) grown from seeds: tissue like that at the seeds, on the seeds' side
/// of the middle between it and the liver. Guards against leaks: passages narrower than half the body's own
/// half-width are closed, and nothing farther than 4 half-widths from its centre is taken.
Mask grow_body(const Field& ct, const std::vector<Eigen::Vector3i>& seeds, const Tissue& liver);

/// The vena cava, followed from its seeds slice by slice along `axis` (the one that runs head to foot): the
/// cross-section of the next slice is what looks alike within a step of the last one. It ends where its area
/// jumps (the heart) or vanishes. Each cross-section then reaches out to where its blood is half as bright, 5
/// mm at most; a vein that opens there is left out.
Mask follow_cava(const Field& ct, const std::vector<Eigen::Vector3i>& seeds, int axis);

}  // namespace glisson::segmentation
