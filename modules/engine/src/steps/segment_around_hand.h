// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/marked_text.h"
#include "glisson/engine/step_kind.h"

namespace glisson::engine::step {

/// The same, but for the voxels that a hand had corrected.
inline constexpr StepKind segment_around_hand{"segment_around_hand", StepKind::Work::grown_around_hand,
                                              QT_TRANSLATE_NOOP("EditTexts", "Segment, corrections kept")};

}  // namespace glisson::engine::step
