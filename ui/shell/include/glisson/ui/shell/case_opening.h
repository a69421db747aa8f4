// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "glisson/engine/commands.h"

namespace glisson::ui {

/// What opening or dropping a path means: a case, a folder of DICOM slices, a folder of surfaces, a volume,
/// labels, a surface, a calibration, a cloud or a video. By name and kind only; nothing is read but folders'
/// entries. Empty: nothing that Glisson opens.
std::optional<engine::Command> command_to_open(const std::filesystem::path& path);

}  // namespace glisson::ui
