// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace glisson {

/// The one of `all` whose code this is. @throws std::invalid_argument none is.
template <class All, class Code>
auto named(const All& all, const Code& code, const std::string& text, const char* field) {
  for (const auto one : all)
    if (text == code(one)) return one;
  throw std::invalid_argument(std::string(field) + " '" + text + "' is unknown");
}

}  // namespace glisson
