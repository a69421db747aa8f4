// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/log.h"

#include <cstdio>
#include <utility>

namespace glisson {

Log::Log(Sink sink, LogLevel threshold) : sink_(std::move(sink)), threshold_(threshold) {}

Log Log::to_standard_error(LogLevel threshold) {
  return Log(
      [](LogLevel level, std::string_view line) {
        static constexpr const char* kNames[] = {"debug", "info", "warning", "error"};
        std::fprintf(stderr, "%s: %.*s\n", kNames[static_cast<int>(level)], static_cast<int>(line.size()),
                     line.data());
      },
      threshold);
}

void Log::write(LogLevel level, std::string_view line) const {
  if (sink_ && level >= threshold_) sink_(level, line);
}

}  // namespace glisson
