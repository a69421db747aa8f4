// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace glisson {

enum class LogLevel { debug, info, warning, error };

/// Where log lines go. Values are passed to whoever needs one; there is no global logger.
class Log {
 public:
  using Sink = std::function<void(LogLevel, std::string_view)>;

  /// Discards everything.
  Log() = default;
  explicit Log(Sink sink, LogLevel threshold = LogLevel::info);

  void write(LogLevel level, std::string_view line) const;

 private:
  Sink sink_;
  LogLevel threshold_ = LogLevel::info;
};

}  // namespace glisson
