// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/volume/grid.h"

namespace glisson {

/// The voxels' axis (0 i, 1 j, 2 k) that runs most nearly along one of the patient's.
/// @param of_patient 0 left, 1 back, 2 head.
int axis_along(const VolumeGrid& grid, int of_patient);

}  // namespace glisson
