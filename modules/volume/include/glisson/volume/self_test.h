// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson {

/// Writes a small volume to the work folder and reads it back, in the program that reads foreign files.
/// @throws FileError it comes back differently, or what writing and reading throw.
void try_volumes();

}  // namespace glisson
