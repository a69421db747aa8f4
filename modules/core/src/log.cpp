// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/log.h"

#include <utility>

namespace glisson {

Log::Log(Sink sink, LogLevel threshold) : sink_(std::move(sink)), threshold_(threshold) {}

void Log::write(LogLevel level, std::string_view line) const {
  if (sink_ && level >= threshold_) sink_(level, line);
}

}  // namespace glisson
