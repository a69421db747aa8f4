// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/marked_text.h"
#include "glisson/engine/step_kind.h"

namespace glisson::engine::step {

/// A click told where the border lies, and growth did the rest.
inline constexpr StepKind correct_around{"correct_around", StepKind::Work::by_hand,
                                         QT_TRANSLATE_NOOP("EditTexts", "Correct around a click")};

}  // namespace glisson::engine::step
