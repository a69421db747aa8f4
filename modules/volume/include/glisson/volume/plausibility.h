// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/volume/image.h"

namespace glisson {

/// What speaks against an image being a whole, undamaged CT or MR of an abdomen, before work on it starts.
/// Each is a code with its values, for people to be told:
///   "image.small MM"                the shortest side, under 100 mm: a liver is larger
///   "image.large MM"                the second longest side, over 1000 mm: no scanner is that wide
///   "image.constant_slices N OF"    planes of the stack that hold one value
///   "image.repeated_slices N OF"    planes that are the one before over again
///   "image.zeros PERCENT"           voxels that are exactly 0: in a CT over 40 (0 HU is water), else over 95
///   "image.no_tissue PERCENT"       in a CT: under 5 lie from -150 to 250 HU
///   "image.no_air PERCENT"          in a CT: under 0.1 lie below -300 HU, which a body's
///                                   surroundings and lungs do: it may have been stored without its intercept
/// @pre one value a voxel.
std::vector<std::string> image_doubts(const Image& image);

}  // namespace glisson
