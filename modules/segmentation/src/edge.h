// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "star.h"

namespace glisson::segmentation {

/// What a boundary is moved by.
struct EdgeView {
  const Field& raw;                        ///< not denoised: denoising carries a faint edge outwards
  const std::vector<std::uint8_t>& may;    ///< of each voxel: 0 where the body cannot end
  std::function<double(double)> evidence;  ///< of an intensity, for the body, a mm
  double blur_mm;                          ///< sigma of what an abrupt border looks like in `raw`
  double around;                           ///< intensity of what is around the body
};

/// Moves the boundary along the rays, 3 mm inwards and 0.75 mm outwards at most, to where the evidence that
/// is summed along the ray is greatest, less 0.4 (move - mean of the neighbours' moves)^2 / mm^2. Intensities
/// are means over the ray and its neighbours at one distance from the boundary: along the body's surface,
/// where denoising would mix across it. A ray just outside which the body cannot end stays.
///
/// That counts all that is between body and surroundings for the body: right where tissue lies between, too
/// much where only the image's blur does. So an error function is fitted to each ray, and in the median over
/// the rays its variance is compared with the blur's: up to 1.45 of it the boundary is where the step is half
/// way down (and sigma^2 / r farther out, which is what blur takes from a ball of radius r), from 1.75 on
/// where the evidence has it, and in between in proportion. Where most steps do not lead to what is around
/// the body, as behind a bright rim, the evidence has it alone.
void move_to_edge(const EdgeView& view, Star& star);

}  // namespace glisson::segmentation
