// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace glisson {

/// A name as one value of a note ("surfaces.ignored my%20liver.stl"): what parts values there, and '%', are
/// written as in addresses, so that readers can undo it (RFC 3986, percent-encoding).
std::string note_value(std::string_view name);

}  // namespace glisson
