// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"

/// @file
/// What in a case's folder is the case's: its list of files, and what becomes of all others.

namespace glisson::engine {

/// Says what the case's parts are: a folder that holds it is a case.
inline constexpr const char* kCaseFile = "case.json";

/// A sum over what a file holds (glisson/core/word_sum.h). Empty: it cannot be read, or is
/// larger than any file of a case.
std::string sum_of(const std::filesystem::path& path);

/// Each file below a folder but case.json, with a sum over what it holds, for case.json's "files".
nlohmann::json list_files(const std::filesystem::path& folder);

/// The sum of one file when it is what case.json lists; else, or where nothing is listed, empty.
std::string sum_as_listed(const std::filesystem::path& folder, const std::string& name);

/// The listed files that are no longer what was saved, or gone: somebody else changed them. None where an
/// earlier edition listed nothing. Some of them where it was cancelled. @param document case.json.
std::vector<std::string> changed_files(const std::filesystem::path& folder, const nlohmann::json& document,
                                       const RunContext& context);

/// What a save would lose: everything in `former` that no save of this case wrote, or that somebody has
/// changed since. Puts it into `fresh` as well: files by a second name for the same content, so that it costs
/// no space and nothing is lost when the program is killed. What has a name of the case's is kept as
/// NAME.kept-1, -2, ...
/// @return where the changed ones are now, relative to the folder.
/// @throws FileError what cannot be kept, and why.
std::vector<std::string> carry_over(const std::filesystem::path& former, const std::filesystem::path& fresh);

}  // namespace glisson::engine
