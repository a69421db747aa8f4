// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <string>

namespace glisson {

/// One sentence for a person of what the standard library throws about files: "PATH: cannot be used (REASON).
/// REMEDY".
std::string sentence_of(const std::filesystem::filesystem_error& failure);

/// The same of whatever stopped a piece of work; an Error's own sentence. @param work what was done, as a
/// person calls it. @pre the work has changed nothing
std::string sentence_of(const std::exception& failure, const std::string& work);

}  // namespace glisson
