// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/ply_file.h"

#include <bit>
#include <cstring>

#include "glisson/core/error.h"
#include "mesh_bytes.h"
#include "text_scanner.h"

namespace glisson {
namespace {

/// The beginning of a word of the file, for an error's sentence: a binary one may hold anything.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, 40));
  for (char& letter : text)
    if (letter < ' ' || letter > '~') letter = '?';
  return text;
}

constexpr const char* kExport = "The file is damaged, or its exporter is: export it anew";

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

/// The header, line by line; what it does not understand it refuses by the line's number.
class HeaderParser {
 public:
  HeaderParser(std::string_view content, const std::string& name) : lines_(content, name), name_(name) {}

  Header parse() {
    std::string_view line;
    if (!lines_.next_line(line) || line != "ply")
      throw InputError(name_, "", "is not a PLY file (its first line is not \"ply\")", "Choose another file");
    bool has_format = false;
    for (number_ = 2; lines_.next_line(line); ++number_) {
      TextScanner words(line, name_);
      const std::string_view key = words.token();
      if (key == "end_header") {
        if (!has_format) fail("no format was named");
        header_.size = lines_.position();
        return std::move(header_);
      }
      if (key == "format") {
        parse_format(words.token());
        has_format = true;
      } else if (key == "element") {
        parse_element(words);
      } else if (key == "property") {
        if (header_.elements.empty()) fail("a property stands before any element");
        header_.properties.back().push_back(parse_property(words));
      } else if (!key.empty() && key != "comment" && key != "obj_info") {
        fail("\"" + shown(key) + "\" is no entry of a PLY header");
      }
    }
    fail("the file ends before end_header");
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(name_, "header, line " + std::to_string(number_), problem, kExport);
  }

  void parse_format(std::string_view format) {
    if (format == "ascii")
      header_.encoding = Encoding::ascii;
    else if (format == "binary_little_endian")
      header_.encoding = Encoding::little;
    else if (format == "binary_big_endian")
      header_.encoding = Encoding::big;
    else
      fail("unknown format \"" + shown(format) + "\"");
  }

  void parse_element(TextScanner& words) {
    PlyElement element;
    element.name = words.token();
    if (!TextScanner::parse(words.token(), element.count) || element.count < 0)
      fail("an element has no valid count");
    for (const PlyElement& other : header_.elements)
      if (other.name == element.name) fail("element " + shown(element.name) + " comes a second time");
    header_.elements.push_back(std::move(element));
    header_.properties.emplace_back();
  }

  Property parse_property(TextScanner& words) const {
    Property property;
    std::string_view word = words.token();
    if (word == "list") {
      property.is_list = true;
      if (!parse_type(words.token(), property.count_type) || property.count_type >= Type::f32)
        fail("a list's count has no integer type");
      word = words.token();
    }
    if (!parse_type(word, property.type)) fail("unknown property type \"" + shown(word) + "\"");
    property.name = words.token();
    if (property.name.empty()) fail("a property has no name");
    for (const Property& other : header_.properties.back())  // two columns of one name have twice the rows
      if (other.name == property.name) fail("property " + shown(property.name) + " comes a second time");
    return property;
  }

  TextScanner lines_;
  const std::string& name_;
  int number_ = 1;
  Header header_;
};

/// Reads one number after the other from an ascii or a binary body.
class Body {
 public:
  Body(std::string_view content, const Header& header, const std::string& name)
      : encoding_(header.encoding), bytes_(content.substr(header.size)), text_(bytes_, name), name_(name) {}

  std::size_t remaining() const { return encoding_ == Encoding::ascii ? text_.remaining() : bytes_.size(); }
  std::size_t least_size(Type type) const { return encoding_ == Encoding::ascii ? 1 : size_of(type); }

  double read(Type type, const std::string& field) {
    return encoding_ == Encoding::ascii ? read_word(field) : read_binary(type, field);
  }

 private:
  double read_word(const std::string& field) {
    const std::string_view word = text_.token();
    double value = 0.0;
    if (TextScanner::parse(word, value)) return value;
    // A number too small for a double is as good as zero; one too large is none.
    const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    if (tiny && word.find_first_not_of("+-.0123456789eE") == std::string_view::npos) return 0.0;
    throw InputError(
        name_, field,
        word.empty() ? "the file ends here" : "holds \"" + shown(word) + "\", which is no number", kExport);
  }

  double read_binary(Type type, const std::string& field) {
    const std::size_t size = size_of(type);
    if (bytes_.size() < size) throw InputError(name_, field, "the file ends here", kExport);
    unsigned char raw[8];
    std::memcpy(raw, bytes_.data(), size);
    bytes_.remove_prefix(size);
    const bool swap = (encoding_ == Encoding::big) == (std::endian::native == std::endian::little);
    if (swap)
      for (std::size_t i = 0; i < size / 2; ++i) std::swap(raw[i], raw[size - 1 - i]);
    return decode(raw, type);
  }

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

/// A count that the file cannot hold is refused before anything is allocated for it.
void check_count(const Body& body, const PlyElement& element, const std::vector<Property>& properties,
                 const std::string& name) {
  std::size_t least = 0;
  for (const Property& p : properties) least += body.least_size(p.is_list ? p.count_type : p.type);
  check_rows(name, element.name, static_cast<double>(element.count));
  if (least == 0 && element.count > 0)
    throw InputError(name, element.name, "has rows but no properties", kExport);
  const std::size_t fitting = least == 0 ? 0 : body.remaining() / least;
  if (static_cast<std::size_t>(element.count) > fitting)
    throw InputError(name, element.name + " " + std::to_string(fitting),
                     "the file ends before it, and the header announces " + std::to_string(element.count),
                     kExport);
}

std::vector<double> read_list(Body& body, const Property& property, const std::string& field,
                              const std::string& name) {
  const double length = body.read(property.count_type, field);
  const auto fit = body.remaining() / body.least_size(property.type) + 1;
  if (!(length >= 0.0) || length > static_cast<double>(fit))
    throw InputError(name, field, "has a list longer than the file", kExport);
  std::vector<double> list(static_cast<std::size_t>(length));
  for (double& value : list) value = body.read(property.type, field);
  return list;
}

/// What all rows of a file hold, bytes: short lists take many times what they take in the file.
class Held {
 public:
  explicit Held(const std::string& name) : name_(name) {}
  void add(std::size_t bytes, const std::string& field) {
    bytes_ += bytes;
    if (bytes_ > kMost)
      throw InputError(name_, field, "holds more than a mesh does, with the rows before it",
                       "Make the mesh coarser, or leave out what is no point and no face");
  }

 private:
  static constexpr std::size_t kMost = 800000000;
  const std::string& name_;
  std::size_t bytes_ = 0;
};

void read_element(Body& body, PlyElement& element, const std::vector<Property>& properties, Held& held,
                  const std::string& name) {
  check_count(body, element, properties, name);
  for (long i = 0; i < element.count; ++i) {
    const std::string field = element.name + " " + std::to_string(i);
    for (const Property& p : properties)
      if (p.is_list) {
        std::vector<double> list = read_list(body, p, field, name);
        held.add(sizeof list + 16 + list.size() * sizeof(double), field);
        element.lists[p.name].push_back(std::move(list));
      } else {
        held.add(sizeof(double), field);
        element.scalars[p.name].push_back(body.read(p.type, field));
      }
  }
}

}  // namespace

std::vector<PlyElement> parse_ply(std::string_view content, const std::string& name) {
  Header header = HeaderParser(content, name).parse();
  Body body(content, header, name);
  Held held(name);
  for (std::size_t e = 0; e < header.elements.size(); ++e)
    read_element(body, header.elements[e], header.properties[e], held, name);
  return std::move(header.elements);
}

std::vector<PlyElement> read_ply(const std::filesystem::path& path) {
  return parse_ply(mesh_bytes(path), path.string());
}

}  // namespace glisson
