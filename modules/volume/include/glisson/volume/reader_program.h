// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace glisson {

/// What the program that reads volumes could do although it must not, tried by itself: "network", "program"
/// (start one), "write" and "read" (elsewhere). Empty: it is confined. A kernel without Landlock leaves the
/// last two, one without seccomp the first two, a build with sanitizers all.
/// @throws FileError the program is missing.
std::vector<std::string> reader_escapes();

}  // namespace glisson
