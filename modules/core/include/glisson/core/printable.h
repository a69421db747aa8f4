// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace glisson {

/// Text that a foreign file may have brought along, as a person may see it: control characters, of which a
/// terminal obeys some, become '?', and what is longer is cut ("...").
/// @param text UTF-8. @param most bytes; 0: all of it.
std::string printable(const std::string& text, std::size_t most = 0);

}  // namespace glisson
