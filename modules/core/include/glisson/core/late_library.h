// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace glisson {

/// What a library of our own offers that is loaded only when it is first needed: looked for in ../lib/glisson
/// of the running program, then where it was built. It is never let go.
/// @param symbol the name of a variable in it. @return the variable's address.
/// @throws FileError it is missing, or is not what it should be.
const void* late_symbol(const std::string& library, const std::filesystem::path& built,
                        const std::string& symbol);

}  // namespace glisson
