// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "glisson/core/error.h"

namespace glisson::reader {
namespace {

bool is_between(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r' || letter == ',';
}

bool fits(std::string_view word, const NumberType& type) {
  if (word.front() == '+') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return false;
  if (!type.is_whole) return true;
  const double most = std::ldexp(1.0, 8 * type.bytes - (type.is_signed ? 1 : 0));
  return value == std::floor(value) && value < most && value >= (type.is_signed ? -most : 0.0);
}

}  // namespace

void check_text_values(const Request& request, const std::string& field, std::string_view text, double count,
                       const NumberType& type) {
  double seen = 0.0;
  for (std::size_t at = 0; at < text.size();) {
    if (is_between(text[at])) {
      ++at;
      continue;
    }
    const auto* const end = std::find_if(text.data() + at, text.data() + text.size(), is_between);
    const std::string_view word(text.data() + at, static_cast<std::size_t>(end - text.data()) - at);
    at += word.size();
    ++seen;
    if (!fits(word, type))
      throw InputError(
          request.name, field,
          "holds \"" + std::string(word.substr(0, 40)) + "\", which its number type does not hold",
          "Correct the type, or export the volume again");
  }
  if (seen != count)
    throw InputError(request.name, field,
                     "holds " + std::to_string(static_cast<long>(seen)) + " numbers where " +
                         std::to_string(static_cast<long>(count)) + " are expected",
                     "The header is damaged: export the volume again");
}

}  // namespace glisson::reader
