// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/ply_file.h"

#include <bit>
#include <cstring>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "text_scanner.h"

namespace glisson {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class Encoding { ascii, little, big };

struct Property {
  std::string name;
  Type type = Type::f32;
  bool is_list = false;
  Type count_type = Type::u8;
};
struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::vector<Property>> properties;  ///< of each element
  std::size_t size = 0;                           ///< bytes up to the body
};

std::size_t size_of(Type type) {
  static constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<int>(type)];
}

bool parse_type(std::string_view word, Type& type) {
  static constexpr std::pair<const char*, Type> kNames[] = {
      {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
      {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
      {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
      {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};
  for (const auto& [name, value] : kNames) {
    if (word != name) continue;
    type = value;
    return true;
  }
  return false;
}

Property parse_property(TextScanner& words, const TextScanner& at) {
  Property property;
  std::string_view word = words.token();
  if (word == "list") {
    property.is_list = true;
    if (!parse_type(words.token(), property.count_type) || property.count_type >= Type::f32)
      at.fail("a list's count has no integer type");
    word = words.token();
  }
  if (!parse_type(word, property.type)) at.fail("unknown property type \"" + std::string(word) + "\"");
  property.name = words.token();
  if (property.name.empty()) at.fail("a property has no name");
  return property;
}

Header parse_header(std::string_view content, const std::string& name) {
  TextScanner scanner(content, name);
  std::string_view line;
  if (!scanner.next_line(line) || line != "ply")
    throw InputError(name, "", "is not a PLY file (its first line is not \"ply\")", "Choose another file");
  Header header;
  bool has_format = false;
  while (scanner.next_line(line)) {
    TextScanner words(line, name);
    const std::string_view key = words.token();
    if (key == "end_header") {
      if (!has_format) scanner.fail("the header has no format line");
      header.size = scanner.position();
      return header;
    }
    if (key == "format") {
      const std::string_view format = words.token();
      if (format == "ascii")
        header.encoding = Encoding::ascii;
      else if (format == "binary_little_endian")
        header.encoding = Encoding::little;
      else if (format == "binary_big_endian")
        header.encoding = Encoding::big;
      else
        scanner.fail("unknown format \"" + std::string(format) + "\"");
      has_format = true;
    } else if (key == "element") {
      PlyElement element;
      element.name = words.token();
      element.count = words.integer();
      if (element.count < 0) scanner.fail("an element's count is negative");
      header.elements.push_back(std::move(element));
      header.properties.emplace_back();
    } else if (key == "property") {
      if (header.elements.empty()) scanner.fail("a property stands before any element");
      header.properties.back().push_back(parse_property(words, scanner));
    }  // comment, obj_info and what we do not know say nothing of the data
  }
  throw InputError(name, "header", "has no end_header line", "Export the file anew");
}

/// Reads one number after the other from an ascii or a binary body.
class Body {
 public:
  Body(std::string_view content, const Header& header, const std::string& name)
      : encoding_(header.encoding), bytes_(content.substr(header.size)), text_(bytes_, name), name_(name) {}

  std::size_t remaining() const { return encoding_ == Encoding::ascii ? text_.remaining() : bytes_.size(); }
  std::size_t least_size(Type type) const { return encoding_ == Encoding::ascii ? 1 : size_of(type); }

  double read(Type type, const std::string& field) {
    if (encoding_ == Encoding::ascii) {
      double value = 0.0;
      const std::string_view word = text_.token();
      if (!TextScanner::parse(word, value))
        throw InputError(name_, field,
                         word.empty()
                             ? "the file ends here"
                             : "holds \"" + std::string(word.substr(0, 40)) + "\", which is not a number",
                         "Export the file anew");
      return value;
    }
    const std::size_t size = size_of(type);
    if (bytes_.size() < size) throw InputError(name_, field, "the file ends here", "Export the file anew");
    unsigned char raw[8];
    std::memcpy(raw, bytes_.data(), size);
    bytes_.remove_prefix(size);
    const bool swap = (encoding_ == Encoding::big) == (std::endian::native == std::endian::little);
    if (swap)
      for (std::size_t i = 0; i < size / 2; ++i) std::swap(raw[i], raw[size - 1 - i]);
    return decode(raw, type);
  }

 private:
  template <class T>
  static double as(const unsigned char* raw) {
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return static_cast<double>(value);
  }
  static double decode(const unsigned char* raw, Type type) {
    switch (type) {
      case Type::i8:
        return as<std::int8_t>(raw);
      case Type::u8:
        return as<std::uint8_t>(raw);
      case Type::i16:
        return as<std::int16_t>(raw);
      case Type::u16:
        return as<std::uint16_t>(raw);
      case Type::i32:
        return as<std::int32_t>(raw);
      case Type::u32:
        return as<std::uint32_t>(raw);
      case Type::f32:
        return as<float>(raw);
      case Type::f64:
        break;
    }
    return as<double>(raw);
  }

  Encoding encoding_;
  std::string_view bytes_;
  TextScanner text_;
  std::string name_;
};

void read_element(Body& body, PlyElement& element, const std::vector<Property>& properties,
                  const std::string& name) {
  std::size_t least = 0;
  for (const Property& p : properties) least += body.least_size(p.is_list ? p.count_type : p.type);
  if (static_cast<std::size_t>(element.count) > body.remaining() / std::max<std::size_t>(least, 1))
    throw InputError(name, "element " + element.name,
                     "the header announces " + std::to_string(element.count) + ", more than the file holds",
                     "Export the file anew");
  for (long i = 0; i < element.count; ++i) {
    const std::string field = element.name + " " + std::to_string(i);
    for (const Property& p : properties) {
      if (!p.is_list) {
        element.scalars[p.name].push_back(body.read(p.type, field));
        continue;
      }
      const double length = body.read(p.count_type, field);
      if (!(length >= 0.0) || length > static_cast<double>(body.remaining() / body.least_size(p.type) + 1))
        throw InputError(name, field, "has a list longer than the file", "Export the file anew");
      std::vector<double> list(static_cast<std::size_t>(length));
      for (double& value : list) value = body.read(p.type, field);
      element.lists[p.name].push_back(std::move(list));
    }
  }
}

}  // namespace

std::vector<PlyElement> parse_ply(std::string_view content, const std::string& name) {
  Header header = parse_header(content, name);
  Body body(content, header, name);
  for (std::size_t e = 0; e < header.elements.size(); ++e)
    read_element(body, header.elements[e], header.properties[e], name);
  return std::move(header.elements);
}

std::vector<PlyElement> read_ply(const std::filesystem::path& path) {
  return parse_ply(read_file(path), path.string());
}

}  // namespace glisson
