// SPDX-License-Identifier: GPL-3.0-or-later
#include "xml_scanner.h"

#include <algorithm>

#include "glisson/core/error.h"

namespace glisson {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == ':' || c == '.';
}

}  // namespace

void XmlScanner::fail(const std::string& problem) const {
  const auto line =
      1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(position_), '\n');
  throw InputError(name_, "line " + std::to_string(line), problem, "The file is damaged: export it again");
}

void XmlScanner::skip_to(std::string_view mark, const char* problem) {
  const std::size_t at = text_.find(mark, position_);
  if (at == std::string_view::npos) fail(problem);
  position_ = at + mark.size();
}

void XmlScanner::skip_space() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
}

std::string XmlScanner::word() {
  const std::size_t begin = position_;
  while (position_ < text_.size() && is_name(text_[position_])) ++position_;
  if (position_ == begin) fail("a tag or an attribute has no name");
  return std::string(text_.substr(begin, position_ - begin));
}

std::string XmlScanner::attribute_value() {
  const char quote = position_ < text_.size() ? text_[position_] : '\0';
  if (quote != '"' && quote != '\'') fail("an attribute has no value in quotation marks");
  const std::size_t begin = ++position_;
  const std::size_t end = text_.find(quote, begin);
  if (end == std::string_view::npos) fail("an attribute's value does not end");
  std::string value(text_.substr(begin, end - begin));
  if (value.find('<') != std::string::npos) fail("an attribute's value holds a tag");
  static constexpr std::pair<std::string_view, char> kEntities[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
  for (std::size_t at = value.find('&'); at != std::string::npos; at = value.find('&', at + 1)) {
    const auto* known = std::find_if(std::begin(kEntities), std::end(kEntities), [&](const auto& entity) {
      return std::string_view(value).substr(at).starts_with(entity.first);
    });
    if (known == std::end(kEntities)) fail("an attribute holds an entity that is not known");
    value.replace(at, known->first.size(), 1, known->second);
  }
  position_ = end + 1;
  return value;
}

XmlScanner::Token XmlScanner::next() {
  while (starts("<?") || starts("<!--")) {
    if (starts("<?"))
      skip_to("?>", "an instruction does not end");
    else
      skip_to("-->", "a comment does not end");
  }
  Token token;
  if (position_ >= text_.size()) return token;
  if (text_[position_] != '<') {
    const std::size_t end = std::min(text_.find('<', position_), text_.size());
    token.kind = Kind::text;
    token.text = text_.substr(position_, end - position_);
    position_ = end;
    return token;
  }
  if (starts("<!")) fail("holds a document type or a section that is not read");
  ++position_;
  const bool closes = starts("/");
  if (closes) ++position_;
  token.kind = closes ? Kind::close : Kind::open;
  token.name = word();
  skip_space();
  while (!closes && position_ < text_.size() && text_[position_] != '>' && text_[position_] != '/') {
    const std::string key = word();
    skip_space();
    if (!starts("=")) fail("the attribute " + key.substr(0, 40) + " has no value");
    ++position_;
    skip_space();
    if (!token.attributes.emplace(key, attribute_value()).second)
      fail("the attribute " + key.substr(0, 40) + " stands twice");
    skip_space();
  }
  if (!closes && starts("/")) {
    token.empty = true;
    ++position_;
  }
  if (!starts(">")) fail("a tag does not end");
  ++position_;
  return token;
}

}  // namespace glisson
