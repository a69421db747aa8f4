// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/marked_text.h"
#include "glisson/engine/step_kind.h"

namespace glisson::engine::step {

/// Growth, or a network, made all labels anew, or those that were asked for.
inline constexpr StepKind segment{"segment", StepKind::Work::grown,
                                  QT_TRANSLATE_NOOP("EditTexts", "Segment")};

}  // namespace glisson::engine::step
