// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/note_value.h"

namespace glisson {

std::string note_value(std::string_view name) {
  std::string value;
  for (const char letter : name) {
    if (letter == ' ')
      value += "%20";
    else if (letter == ':')
      value += "%3A";
    else if (letter == '%')
      value += "%25";
    else
      value += letter;
  }
  return value;
}

}  // namespace glisson
