// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/numbered_files.h"

#include <algorithm>
#include <cstdlib>
#include <regex>

#include "glisson/core/error.h"

namespace glisson {

std::optional<NumberedFiles> NumberedFiles::of(const std::string& pattern) {
  static const std::regex kNumber("%(0?)([0-9]{0,2})d");
  std::smatch match;
  if (!std::regex_search(pattern, match, kNumber)) return {};
  NumberedFiles files;
  files.before_ = match.prefix();
  files.after_ = match.suffix();
  files.fill_ = match[1].length() == 0 ? ' ' : '0';
  files.digits_ = std::atoi(match[2].str().c_str());
  return files;
}

std::filesystem::path NumberedFiles::at(int number) const {
  const std::string digits = std::to_string(number);
  const auto missing = std::max(0, digits_ - static_cast<int>(digits.size()));
  return before_ + std::string(static_cast<std::size_t>(missing), fill_) + digits + after_;
}

std::vector<std::pair<int, std::filesystem::path>> NumberedFiles::existing() const {
  constexpr int kMost = 100000, kWidestGap = 1000;
  std::vector<std::pair<int, std::filesystem::path>> files;
  for (int number = 0, gap = 0; number < kMost && gap <= kWidestGap; ++number) {
    const std::filesystem::path file = at(number);
    gap = std::filesystem::exists(file) ? 0 : gap + 1;
    if (gap == 0) files.emplace_back(number, file);
  }
  if (files.empty())
    throw FileError(before_ + "%" + (fill_ == '0' ? "0" : "") + (digits_ > 0 ? std::to_string(digits_) : "") +
                    "d" + after_ + ": no file of this name exists. Check the pattern's folder and number.");
  return files;
}

}  // namespace glisson
