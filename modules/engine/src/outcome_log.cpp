// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/outcome_log.h"

#include <cstdio>
#include <string>

namespace glisson::engine {

void log_outcome(const Log& log, const Outcome& outcome,
                 const std::function<std::string(std::string_view sentence)>& told) {
  static constexpr const char* kStatus[] = {"done", "cancelled", "failed"};
  char seconds[32] = {};
  std::snprintf(seconds, sizeof seconds, "%.3f s", outcome.seconds);
  std::string line = outcome.command + ' ' + kStatus[static_cast<int>(outcome.status)] + ' ' + seconds;
  if (!outcome.error.empty()) line += ": " + told(outcome.error);
  // A note's code comes first; its values may be names.
  for (const std::string& note : outcome.notes) line += "; " + note.substr(0, note.find_first_of(" :"));
  log.write(outcome.status == Status::failed ? LogLevel::error : LogLevel::info, line);
}

}  // namespace glisson::engine
