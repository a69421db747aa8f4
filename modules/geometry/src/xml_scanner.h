// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace glisson {

/// Cuts XML into tags and the text between them, as far as files of data need it: no document types, no
/// entities but the five that XML has. Comments and processing instructions are passed over.
class XmlScanner {
 public:
  XmlScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  enum class Kind { open, close, text, end };
  struct Token {
    Kind kind = Kind::end;
    std::string name;                               ///< of a tag
    std::map<std::string, std::string> attributes;  ///< of an opening one
    bool empty = false;                             ///< an opening tag that closes itself
    std::string_view text;                          ///< between tags, as it stands
  };
  /// @throws InputError naming the line.
  Token next();

  std::size_t position() const { return position_; }
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  bool starts(std::string_view mark) const { return text_.substr(position_).starts_with(mark); }
  void skip_to(std::string_view mark, const char* problem);
  void skip_space();
  std::string word();
  std::string attribute_value();

  std::string_view text_;
  std::string name_;
  std::size_t position_ = 0;
};

}  // namespace glisson
