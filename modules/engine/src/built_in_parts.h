// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/engine/part.h"

namespace glisson::engine {

/// The parts below parts/, in no order. Written by CMake from the folder's files: part::NAME of NAME.h.
std::vector<Part> built_in_parts();

}  // namespace glisson::engine
