// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace glisson {

/// A sum over what a file holds, which tells changes from none, not forgeries: FNV-1a over words of eight
/// bytes (the last one filled up with zeros) and the size.
class WordSum {
 public:
  /// All pieces but the last are whole words.
  void add(std::string_view piece) {
    size_ += piece.size();
    std::uint64_t word = 0;
    for (; piece.size() >= sizeof word; piece.remove_prefix(sizeof word)) {
      std::memcpy(&word, piece.data(), sizeof word);
      add_word(word);
    }
    if (piece.empty()) return;
    word = 0;
    std::memcpy(&word, piece.data(), piece.size());
    add_word(word);
  }
  /// 16 digits, lowest first.
  std::string text() const {
    WordSum whole = *this;
    whole.add_word(size_);
    std::string text;
    for (int digit = 0; digit < 16; ++digit, whole.sum_ >>= 4U) text += "0123456789abcdef"[whole.sum_ & 15U];
    return text;
  }

 private:
  void add_word(std::uint64_t word) { sum_ = (sum_ ^ word) * 1099511628211ULL; }

  std::uint64_t sum_ = 14695981039346656037ULL, size_ = 0;
};

/// The sum of a file that would hold this.
inline std::string sum_of_content(std::string_view content) {
  WordSum sum;
  sum.add(content);
  return sum.text();
}

}  // namespace glisson
