// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/experiments/demo.h"

namespace glisson::experiments {

/// What the demo's patient is made from.
enum class DemoInput { synthetic, open_case, labels, surfaces };
DemoInput input_of(const DemoOptions& options);

}  // namespace glisson::experiments
