// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

/// @file
/// A case opens what lies in its own folder, and nothing else: whoever made it does not speak for its reader.

namespace glisson::engine {

/// The file that `case.json` names in a field: below the case's folder. @throws InputError elsewhere.
std::filesystem::path file_of_case(const std::filesystem::path& folder, const char* field,
                                   const std::string& named);

/// @throws InputError when the case's folder holds a link that leads out of it, or round in a circle, or what
/// is
///   neither a file nor a folder (a pipe would never end, a device would be switched on).
void require_own_files(const std::filesystem::path& folder);

/// Whether a file, or a folder with all that is in it, really lies below a case's folder: no link leads out,
/// and no pipe or device lies there. False where it does not exist.
bool lies_in_case(const std::filesystem::path& folder, const std::filesystem::path& place);

}  // namespace glisson::engine
