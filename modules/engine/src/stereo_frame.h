// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"
#include "glisson/engine/parts/frame.h"

namespace glisson::engine {

/// The state with this pair. A calibration of another size is told where the two are used: either may be the
/// one that comes next.
/// @param mask the file that the mask was read from, where there is one.
/// @throws InputError when the pictures, or the mask, differ in size.
Applied with_frame(const CaseState& state, StereoInput input, const std::filesystem::path& mask);

}  // namespace glisson::engine
