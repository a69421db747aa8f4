// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "glisson/core/error.h"
#include "raw_volume.h"

/// @file
/// What headers of text have in common: lines one after the other, and refusals that name a field.

namespace glisson::reader {

/// The lines of a file's beginning, without what ends them.
class HeaderLines {
 public:
  HeaderLines(const Request& request, std::uintmax_t longest)
      : stream_(request.path, std::ios::binary), longest_(longest) {}

  /// @return false at the end of the file, or behind the longest header.
  bool next(std::string& line) {
    if (end_ >= longest_ || !std::getline(stream_, line)) return false;
    end_ += line.size() + 1;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return true;
  }
  /// Bytes of the lines so far: where what follows them begins.
  std::uintmax_t end() const { return end_; }

 private:
  std::ifstream stream_;
  std::uintmax_t longest_, end_ = 0;
};

/// Refuses a field of a header, with a format's own remedy where no other is given.
struct HeaderRefusal {
  const char* remedy;
  [[noreturn]] void operator()(const Request& request, const std::string& field, const std::string& problem,
                               const std::string& other = {}) const {
    throw InputError(request.name, field, problem, other.empty() ? remedy : other);
  }
};

}  // namespace glisson::reader
