// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "glisson/core/log.h"

namespace glisson {

/// Where a program keeps what is of no patient and must outlive it: below XDG_STATE_HOME (~/.local/state), in
/// folders that no other may enter. Empty: there is no home.
std::filesystem::path state_folder();
/// In it, of logs and of crash reports.
std::filesystem::path log_folder();
std::filesystem::path crash_folder();

/// A log in a file, a line of time, process and level each: glisson.log; when it is full it becomes
/// glisson.log.1, that one .2, and so on. Several programs may write the same log.
/// @param folder made when there is none yet.
/// @param bytes after which a new one is begun.
/// @param kept how many former ones stay.
/// @return a log that discards everything where it cannot be written: no work fails for its log.
Log log_to_file(const std::filesystem::path& folder, std::size_t bytes = std::size_t{1} << 20U, int kept = 4);

}  // namespace glisson
