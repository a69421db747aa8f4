// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glisson {

/// Files whose names differ by a number, as a printf-like pattern says: "cloud_%02d.ply".
class NumberedFiles {
 public:
  /// Empty: the pattern holds no number (%d, %4d, %04d).
  static std::optional<NumberedFiles> of(const std::string& pattern);

  /// The name with this number, whether it is there or not.
  std::filesystem::path at(int number) const;
  /// Of a number in the names, at least.
  int digits() const { return digits_; }
  /// Those that are there, in ascending order, up to a gap of more than 1000 numbers: lost ones do not hide
  /// those after them. The first is 1000 at most.
  /// @throws FileError there is none.
  std::vector<std::pair<int, std::filesystem::path>> existing() const;

 private:
  NumberedFiles() = default;

  std::string before_, after_;  ///< of the pattern, around the number
  int digits_ = 0;
  char fill_ = ' ';
};

}  // namespace glisson
