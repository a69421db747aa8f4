// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"

namespace glisson::experiments {

/// A page on one registration: how it ended, how far off organ and each lesion may be, where else the organ
/// may be, what speaks for and against it. Atomic. @throws FileError.
/// @param subject model and cloud, as they were named.
/// @param figures of the registration (engine::Register), left out where they are not there.
/// @param ending registration::ending_code().
/// @param doubts sentences.
void write_registration_report(const std::filesystem::path& path, const std::string& subject,
                               const Figures& figures, const std::string& ending,
                               const std::vector<std::string>& doubts);

}  // namespace glisson::experiments
