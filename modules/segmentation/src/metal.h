// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "glisson/volume/image.h"
#include "glisson/volume/label_volume.h"

namespace glisson::segmentation {

/// Metal throws streaks across the slices that it lies in, and what they cross looks like no liver. In the
/// slices of the liver and 20 mm beyond: "image.metal SLICES", where something is denser than any bone. No
/// value: nothing is, or no CT. Where the values end at 1023 HU, as in many CTs, metal looks like bone.
/// @pre labels on the image's grid.
std::optional<std::string> metal_note(const Image& image, const LabelVolume& labels);

}  // namespace glisson::segmentation
