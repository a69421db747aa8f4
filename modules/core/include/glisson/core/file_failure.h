// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace glisson {

/// One sentence for a person of what the standard library throws about files: "PATH: cannot be used (REASON).
/// REMEDY".
std::string sentence_of(const std::filesystem::filesystem_error& failure);

}  // namespace glisson
