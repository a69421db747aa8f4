// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field.h"
#include "glisson/core/run_context.h"

namespace glisson::segmentation {

/// How much more a place of an MRI is bright than its tissue makes it (the coils' sensitivity): N4, Tustison
/// et al. 2010 (IEEE Trans Med Imaging 29:1310), by ITK.
/// @param coarse the MRI on voxels of some millimetres, positive. @param tissue what is no air.
/// @return factors on the same grid; all 1 where the tissue shows one value only.
Cancellable<Field> bias_field(const Field& coarse, const Mask& tissue, const RunContext& context);

}  // namespace glisson::segmentation
