// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace glisson {

/// The folder of the running program; its libraries are in ../lib/glisson. Empty: nothing tells (no /proc).
/// Then nothing of ours is to be looked for, least of all in the folder that one works in.
std::optional<std::filesystem::path> program_folder();

}  // namespace glisson
