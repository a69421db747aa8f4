// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bodies.h"

namespace glisson::segmentation {

/// The three largest bodies of tissue darker than the liver in it that hold a ball of 8 mm and have 1 ml;
/// none that a click for the liver or for a lesion lies in, whose person has seen it, and none of the lesions
/// found.
/// @param ct denoised, on the bodies' grid. @param clicks voxels of it.
std::vector<DarkBody> dark_bodies(const Field& ct, const Bodies& bodies,
                                  const std::vector<Eigen::Vector3i>& clicks);

}  // namespace glisson::segmentation
