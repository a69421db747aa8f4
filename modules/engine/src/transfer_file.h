// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/atlas/transfer.h"

namespace glisson::engine {

/// A transfer as a file of a case: JSON, LPS, millimetres. @throws FileError.
void write_transfer(const std::filesystem::path& path, const atlas::Transfer& transfer);
/// One of a former edition has no basis. @throws FileError; InputError naming file and field.
atlas::Transfer read_transfer(const std::filesystem::path& path);

/// Whether two are the same but for what millimetres in text round.
bool same_transfer(const atlas::Transfer& a, const atlas::Transfer& b);

}  // namespace glisson::engine
