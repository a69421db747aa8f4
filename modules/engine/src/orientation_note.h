// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/core/run_context.h"
#include "glisson/model/build.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {

/// Adds to the model's notes what its liver's shape says against the way it lies (atlas/orientation.h).
/// @param known null: nobody asks. @return false when cancelled.
bool note_orientation(const atlas::Atlas* known, model::BuiltModel& built, const RunContext& context);

/// The same of labels, of which some voxels stand for all. Empty: cancelled.
Cancellable<std::vector<std::string>> orientation_notes(const atlas::Atlas* known, const LabelMap& labels,
                                                        const RunContext& context);

}  // namespace glisson::engine
