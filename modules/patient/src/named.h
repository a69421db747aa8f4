// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
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

/// A whole number of an object. @throws std::exception it is none, or too large: as an int it would be cut.
inline int whole_number(const nlohmann::json& object, const char* field) {
  const auto value = object.at(field).get<double>();
  if (value != std::trunc(value) || !(std::abs(value) <= std::numeric_limits<int>::max()))
    throw std::invalid_argument(std::string(field) + " is no whole number");
  return static_cast<int>(value);
}

}  // namespace glisson
