// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/engine/step_kind.h"

namespace glisson::engine {

/// The kinds of steps below steps/, in no order. Written by CMake from the folder's files: step::NAME of
/// NAME.h.
std::vector<const StepKind*> built_in_steps();

}  // namespace glisson::engine
