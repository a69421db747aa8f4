// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/marked_text.h"
#include "glisson/engine/step_kind.h"

namespace glisson::engine::step {

/// All labels came from a file.
inline constexpr StepKind import_labels{"import_labels", StepKind::Work::imported,
                                        QT_TRANSLATE_NOOP("EditTexts", "Import labels")};

}  // namespace glisson::engine::step
