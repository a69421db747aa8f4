// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace glisson {

/// Where a folder that is written to `path` really goes: absolute, and at the end of the links, so that a
/// link stays one. @throws FileError see end_of_links.
std::filesystem::path place_for_folder(const std::filesystem::path& path);

/// Where a folder stands between the two renames of exchange_folders() on a file system that cannot exchange:
/// beside it as .NAME.former. Whoever reads the folder looks there where none stands under its own name.
/// @param folder as place_for_folder() gives it.
std::filesystem::path former_name(const std::filesystem::path& folder);

/// Where a folder is read: under its former name where an exchange was killed between its two renames.
/// @param folder as place_for_folder() gives it. @param mark a file that a whole folder of this kind holds.
std::filesystem::path standing_folder(const std::filesystem::path& folder, const char* mark);

/// Puts the folder `fresh` in place of `folder`, in one step as seen from outside: killed at any moment it
/// leaves the former one or the new one whole (see standing_folder), and a folder of a hidden name that
/// sweep_leftovers() knows. Then what a killed exchange had left goes (drop_former), and the change is on the
/// disk. The caller has flushed what is in it.
/// @param fresh on the same file system, below a TemporaryFolder. @param folder as place_for_folder() gives
///   it; need not be there yet.
/// @param mark as above. @throws FileError; the
///   former folder stands then.
void exchange_folders(const std::filesystem::path& fresh, const std::filesystem::path& folder,
                      const char* mark);

/// Removes what a killed exchange has left under the former name beside a whole folder: a copy of a
/// patient's data that nobody looks at. Both must hold `mark`, else all stays.
void drop_former(const std::filesystem::path& folder, const char* mark);

}  // namespace glisson
