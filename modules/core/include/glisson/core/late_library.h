// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/core/error.h"

namespace glisson {

/// A library of our own cannot be used, or the program named here found that one of its own cannot be.
struct MissingLibrary : FileError {
  explicit MissingLibrary(const std::string& path);
};

/// What a library of our own offers that is loaded only when it is first needed. It is looked for in
/// ../lib/glisson of the running program and nowhere else: what may write there could write the program. It
/// is never let go.
/// @param symbol the name of a variable in it. @return the variable's address.
/// @throws MissingLibrary it is missing, or is not what it should be.
const void* late_symbol(const std::string& library, const std::string& symbol);

}  // namespace glisson
