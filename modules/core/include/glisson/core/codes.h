// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "glisson/core/error.h"

/// @file
/// Tables of what a person or a file calls a value, for both ways.

namespace glisson {

template <class T, std::size_t N>
using Codes = std::array<std::pair<const char*, T>, N>;

/// The value of a code; empty: none has it.
template <class T, std::size_t N>
std::optional<T> value_in(const Codes<T, N>& codes, std::string_view code) {
  for (const auto& [known, value] : codes)
    if (code == known) return value;
  return {};
}

/// The code of a value. @pre it has one
template <class T, std::size_t N>
const char* code_in(const Codes<T, N>& codes, T value) {
  for (const auto& [code, known] : codes)
    if (known == value) return code;
  throw PreconditionError("a value that is written has a code");
}

}  // namespace glisson
