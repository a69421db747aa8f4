// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

namespace glisson::experiments {

/// A real pair with all that is needed. The mask says with non-zero what of the left picture is tissue.
struct RealPair {
  Picture left, right, mask;
  StereoRig rig;
};

/// Which part of the pair of `stereo_opencas` is wanted: where its CT surface is known, or all tissue.
enum class OpencasPart { with_truth, tissue };

/// @param folder of `stereo_opencas`: liver tissue. @throws FileError, InputError.
RealPair opencas(const std::filesystem::path& folder, OpencasPart part);
/// @param folder of `stereo_heart`: a silicone heart. @throws FileError, InputError.
RealPair heart(const std::filesystem::path& folder);

}  // namespace glisson::experiments
