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
};

/// Moves the boundary along the rays, 3 mm inwards and 0.75 mm outwards at most, to where the evidence that
/// is summed along the ray is greatest, less 0.4 (move - mean of the neighbours' moves)^2 / mm^2. Intensities
/// are means over the ray and its neighbours at one distance from the boundary: along the body's surface,
/// where denoising would mix across it. A ray just outside which the body cannot end stays.
void move_to_edge(const EdgeView& view, Star& star);

}  // namespace glisson::segmentation
