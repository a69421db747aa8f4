// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace glisson {

/// Whether brackets and braces of a JSON text stand more than 64 deep within each other, those in strings not
/// counted. What is parsed of such a text is copied, written and compared by calls within calls, and would
/// end the program; no list that is read here nests deeper than ten.
bool nests_too_deep(std::string_view json);

}  // namespace glisson
