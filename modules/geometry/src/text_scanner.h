// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include "glisson/core/error.h"

namespace glisson {

/// Cuts text into tokens at white space and knows the line it is at. Numbers do not depend on the locale.
class TextScanner {
 public:
  TextScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  int line() const { return line_; }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return text_.size() - position_; }

  /// Empty at the end.
  std::string_view token() {
    skip_space();
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
    return text_.substr(begin, position_ - begin);
  }

  /// The rest of the current line, without its end; moves to the next line. False at the end of the text.
  bool next_line(std::string_view& rest) {
    if (position_ >= text_.size()) return false;
    std::size_t end = text_.find('\n', position_);
    if (end == std::string_view::npos) end = text_.size();
    rest = text_.substr(position_, end - position_);
    if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
    position_ = end + (end < text_.size() ? 1 : 0);
    ++line_;
    return true;
  }

  /// The next bytes as they are.
  std::string_view raw(std::size_t size) {
    if (size > remaining()) fail("the file ends inside binary data");
    position_ += size;
    return text_.substr(position_ - size, size);
  }

  double number() {
    const std::string_view word = token();
    double value = 0.0;
    if (!parse(word, value)) fail("expected a number, found " + shown(word));
    return value;
  }

  long integer() {
    const std::string_view word = token();
    long value = 0;
    if (!parse(word, value)) fail("expected a whole number, found " + shown(word));
    return value;
  }

  /// A count that the rest of the text can hold: each item takes at least `least_characters`.
  long count(std::size_t least_characters) {
    const long value = integer();
    if (value < 0 || static_cast<std::size_t>(value) > remaining() / least_characters + 1)
      fail("announces " + std::to_string(value) + " items, more than the file holds");
    return value;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(name_, "line " + std::to_string(line_), problem, "Export the file anew");
  }

  template <class Number>
  static bool parse(std::string_view word, Number& value) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    return failure == std::errc() && end == word.data() + word.size() && !word.empty();
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
  static std::string shown(std::string_view word) {
    return word.empty() ? "the end of the file" : "\"" + std::string(word.substr(0, 40)) + "\"";
  }
  void skip_space() {
    while (position_ < text_.size() && is_space(text_[position_])) line_ += text_[position_++] == '\n';
  }

  std::string_view text_;
  std::string name_;
  std::size_t position_ = 0;
  int line_ = 1;
};

}  // namespace glisson
