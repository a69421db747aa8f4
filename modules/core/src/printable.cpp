// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/printable.h"

namespace glisson {

std::string printable(const std::string& text, std::size_t most) {
  std::string shown;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const auto byte = static_cast<unsigned char>(text[n]);
    const auto next = static_cast<unsigned char>(n + 1 < text.size() ? text[n + 1] : 0);
    const bool is_second_set = byte == 0xC2 && next >= 0x80 && next < 0xA0;  // U+0080 to U+009F
    const bool is_control = byte < 0x20 || byte == 0x7F || is_second_set;
    shown += is_control ? '?' : text[n];
    n += is_second_set ? 1 : 0;
  }
  if (most == 0 || shown.size() <= most) return shown;
  const auto is_inside = [&](std::size_t at) {
    return (static_cast<unsigned char>(shown[at]) & 0xC0U) == 0x80U;
  };
  while (most > 0 && is_inside(most)) --most;  // no character is cut in two
  return shown.substr(0, most) + "...";
}

}  // namespace glisson
