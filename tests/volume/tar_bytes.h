// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace glisson::test {

/// One entry of a tar archive (ustar), written byte by byte.
/// @param kind '0' a file, '2' a link to `target`, '5' a folder.
/// @param claimed the size that the header says; 0: that of the content.
inline std::string tar_entry(const std::string& name, const std::string& content, char kind = '0',
                             const std::string& target = {}, std::uint64_t claimed = 0) {
  std::string block(512, '\0');
  const auto put = [&](std::size_t at, const std::string& text) { block.replace(at, text.size(), text); };
  const auto octal = [&](std::size_t at, int digits, std::uint64_t value) {
    char text[24];
    std::snprintf(text, sizeof text, "%0*llo", digits, static_cast<unsigned long long>(value));
    put(at, text);
  };
  put(0, name.substr(0, 100));
  octal(100, 7, 0644);
  octal(108, 7, 0);
  octal(116, 7, 0);
  octal(124, 11, claimed > 0 ? claimed : content.size());
  octal(136, 11, 0);
  put(148, "        ");
  block[156] = kind;
  put(157, target.substr(0, 100));
  put(257, std::string("ustar\00000", 8));
  std::uint64_t sum = 0;
  for (const char byte : block) sum += static_cast<unsigned char>(byte);
  octal(148, 6, sum);
  block[154] = '\0';
  return block + content + std::string((512 - content.size() % 512) % 512, '\0');
}

inline std::string tar_end() { return std::string(1024, '\0'); }

}  // namespace glisson::test
