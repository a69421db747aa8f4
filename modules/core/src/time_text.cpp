// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/time_text.h"

#include <array>
#include <ctime>

namespace glisson {
namespace {

std::string text_of(const struct tm* parts, const char* format) {
  std::array<char, 64> text{};
  if (parts == nullptr || std::strftime(text.data(), text.size(), format, parts) == 0) return {};
  return text.data();
}

}  // namespace

std::string local_time_text(const char* format) {
  const std::time_t now = std::time(nullptr);
  struct tm parts = {};
  return text_of(::localtime_r(&now, &parts), format);
}

std::string utc_time_text(const char* format) {
  const std::time_t now = std::time(nullptr);
  struct tm parts = {};
  return text_of(::gmtime_r(&now, &parts), format);
}

}  // namespace glisson
