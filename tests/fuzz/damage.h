// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cctype>
#include <random>
#include <string>

namespace glisson::fuzz {

/// A number of the text, the first at or after `from`, becomes one that breaks things.
inline std::string with_wild_number(std::string bytes, std::size_t from, std::mt19937& random) {
  constexpr const char* kWild[] = {"-1",    "0",      "99999999999", "4294967296", "-9223372036854775808",
                                   "1e999", "-1e300", "nan",         "2147483647", "1e-320"};
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto begin = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(), is_digit);
  const auto end = std::find_if_not(begin, bytes.end(), is_digit);
  if (begin != end) bytes.replace(begin, end, kWild[random() % std::size(kWild)]);
  return bytes;
}

/// A few bits turned, mostly in the first 600 bytes; sometimes a run of bytes lost, put in or doubled, a
/// number or four bytes made extreme, or the end cut off.
inline std::string damaged(std::string bytes, std::mt19937& random) {
  if (bytes.size() < 8) return bytes + std::string(1, static_cast<char>(random()));
  const std::size_t reach = std::min<std::size_t>(bytes.size(), random() % 4 == 0 ? bytes.size() : 600);
  const std::size_t at = random() % reach;
  switch (random() % 16) {
    case 0:
      bytes.resize(random() % bytes.size());
      return bytes;
    case 1:
      return bytes.erase(at, 1 + random() % 8);
    case 2: {  // each draw a statement: an argument list has no order
      const auto digit = static_cast<char>('0' + random() % 10);
      return bytes.insert(at, 1 + random() % 8, digit);
    }
    case 3: {
      const std::size_t length = random() % 200;
      return bytes.insert(at, bytes.substr(random() % reach, length));
    }
    case 4:
    case 5:
    case 6:
      return with_wild_number(bytes, at, random);
    case 7:
      for (std::size_t i = at; i < std::min(bytes.size(), at + 4); ++i)
        bytes[i] = static_cast<char>(random() % 2 == 0 ? 0xFF : 0x7F);
      return bytes;
    default:
      for (unsigned n = 1 + random() % 3; n > 0; --n)
        bytes[random() % reach] ^= static_cast<char>(1U << (random() % 8));
      return bytes;
  }
}

}  // namespace glisson::fuzz
