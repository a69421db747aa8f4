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
///   and those of scale_doubts().
/// @pre one value a voxel.
std::vector<std::string> image_doubts(const Image& image);

/// What speaks against a CT's voxels being Hounsfield units; of another modality nothing. A CT of an abdomen
/// holds soft tissue, and air in lungs, bowel and around the patient. Values that were stored without the
/// scanner's intercept lie about 1024 too high; where it was added twice, as much too low.
///   "image.no_tissue PERCENT"       under 5 lie from -150 to 250 HU
///   "image.no_air PERCENT"          under 0.1 lie from -1100 to -300 HU (lower: the scanner's padding). A CT
///                                   that was cropped to tissue has none either.
///   "image.shifted HU"              beside one of the two: with so much added there were both, as in a CT
/// @pre one value a voxel.
std::vector<std::string> scale_doubts(const Image& image);

}  // namespace glisson
