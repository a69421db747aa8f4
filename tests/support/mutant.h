// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

namespace glisson::test {

/// What may become of a file on its way: one to four bytes changed, runs of up to `longest` bytes lost or
/// repeated, the end cut off.
inline std::string mutant_of(std::string text, std::mt19937& random, unsigned longest) {
  for (int edit = static_cast<int>(random() % 4); edit >= 0 && !text.empty(); --edit) {
    const std::size_t at = random() % text.size();
    switch (random() % 4) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, 1 + random() % longest);
        break;
      case 2: {  // each draw a statement: an argument list has no order
        const std::size_t length = random() % (2 * longest);
        text.insert(at, text.substr(random() % text.size(), length));
        break;
      }
      default:
        text.resize(at + 1);
    }
  }
  return text;
}

}  // namespace glisson::test
