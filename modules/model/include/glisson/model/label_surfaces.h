// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/patient_model.h"

namespace glisson::model {

/// The closed surfaces that labels enclose, without a model: the liver with everything in it, as "liver", and
/// each other structure and lesion; vessels go on beyond the liver. Marching cubes over a smoothed field that
/// keeps the volume. Lesions below 15 mm3, and what has no voxel, are left out. Empty: cancelled.
/// @param notes takes "lesion.dropped lesion_2 mm3 10" for each lesion that is too small.
/// @throws InputError there is no label at all, or no voxel has one.
Cancellable<std::vector<NamedSurface>> surfaces_of_labels(const LabelMap& labels, const RunContext& context,
                                                          std::vector<std::string>& notes);

}  // namespace glisson::model
