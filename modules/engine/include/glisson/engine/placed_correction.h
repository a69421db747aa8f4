// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/case_state.h"
#include "glisson/patient/correction.h"

namespace glisson::engine {

/// What a line of a file of corrections means in the frame that is followed last: the place of the organ that
/// is drawn at the line's `from`, or where the line's place is drawn.
/// @param file that the line is of, for the error. @pre `line.correction`; a model, a camera, and a frame
/// that was followed. @throws InputError `from` lies beside the organ.
Correction placed_correction(const CaseState& state, const CorrectionLine& line,
                             const std::filesystem::path& file);

}  // namespace glisson::engine
