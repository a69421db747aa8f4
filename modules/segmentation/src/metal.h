// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "glisson/volume/image.h"
#include "glisson/volume/label_volume.h"

namespace glisson::segmentation {

/// Metal throws streaks across the slices that it lies in, and what they cross looks like no liver. In the
/// slices of the liver and 20 mm beyond:
///   "image.metal SLICES"           something is denser than any bone
///   "image.clipped HU SLICES"      the image's values end at so many HU, below metal and in the range of
///                                  bone, and something stands exactly there: nothing tells whether it is
///                                  metal
/// No value: neither, or no CT.
/// @pre labels on the image's grid.
std::optional<std::string> metal_note(const Image& image, const LabelVolume& labels);

}  // namespace glisson::segmentation
