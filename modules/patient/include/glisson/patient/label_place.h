// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glisson/volume/label_volume.h"

namespace glisson {

/// Where to look at a label: the centre of the voxel of it that lies nearest to its middle, CT frame, metres.
/// None: no voxel has it.
std::optional<Point<CtFrame>> place_of(const LabelVolume& labels, Label label);

}  // namespace glisson
