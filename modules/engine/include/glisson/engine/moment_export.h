// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/parts/moments.h"

namespace glisson::engine {

/// Writes what was kept of a moment into a folder that is there: NAME_left.png and NAME_right.png as they
/// were taken, and NAME.json with title, time, level, reason, lesions, pose and nodes (left camera's frame,
/// millimetres). Nothing of it says whose liver it is, but for what a person has written into the title.
/// @param is_drawn whether NAME_overlay.png shows its overlay, for the file. @throws FileError.
void export_moment(const std::filesystem::path& folder, const std::string& name, const KeptMoment& moment,
                   bool is_drawn);

}  // namespace glisson::engine
