// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/labelled_cloud.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

namespace glisson {
namespace {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Format { ascii, little_endian, big_endian };

std::size_t size_of(Scalar type) {
  static constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<int>(type)];
}

std::optional<Scalar> scalar_type(std::string_view name) {
  if (name == "char" || name == "int8") return Scalar::int8;
  if (name == "uchar" || name == "uint8") return Scalar::uint8;
  if (name == "short" || name == "int16") return Scalar::int16;
  if (name == "ushort" || name == "uint16") return Scalar::uint16;
  if (name == "int" || name == "int32") return Scalar::int32;
  if (name == "uint" || name == "uint32") return Scalar::uint32;
  if (name == "float" || name == "float32") return Scalar::float32;
  if (name == "double" || name == "float64") return Scalar::float64;
  return std::nullopt;
}

struct Property {
  std::string name;
  Scalar type = Scalar::float32;
  std::optional<Scalar> list_size;  ///< type of the length of a list; none: a scalar
};
struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};
struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
  std::size_t body = 0;  ///< offset of the first byte after the header
};

constexpr const char* kExport = "Export the cloud again as PLY";

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  std::size_t i = 0;
  while (i < line.size()) {
    while (i < line.size() && (line[i] == ' ' || line[i] == '\t' || line[i] == '\r')) ++i;
    const std::size_t begin = i;
    while (i < line.size() && line[i] != ' ' && line[i] != '\t' && line[i] != '\r') ++i;
    if (i > begin) result.push_back(line.substr(begin, i - begin));
  }
  return result;
}

class HeaderParser {
 public:
  HeaderParser(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  Header parse() {
    if (next_line() != std::vector<std::string_view>{"ply"})
      throw InputError(file_, "", "is not a PLY file (it does not begin with \"ply\")", kExport);
    bool has_format = false;
    for (;;) {
      const std::vector<std::string_view> line = next_line();
      if (line.empty() || line[0] == "comment" || line[0] == "obj_info") continue;
      if (line[0] == "end_header") break;
      if (line[0] == "format") {
        read_format(line);
        has_format = true;
      } else if (line[0] == "element") {
        read_element(line);
      } else if (line[0] == "property") {
        read_property(line);
      } else {
        fail("has an unknown entry \"" + std::string(line[0].substr(0, 40)) + "\"");
      }
    }
    if (!has_format) fail("does not name its format");
    header_.body = position_;
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_, "header, line " + std::to_string(line_), problem, kExport);
  }

  std::vector<std::string_view> next_line() {
    ++line_;
    const std::size_t end = text_.find('\n', position_);
    if (end == std::string_view::npos || line_ > 10000) fail("ends before end_header");
    const std::string_view line = text_.substr(position_, end - position_);
    position_ = end + 1;
    return words(line);
  }

  void read_format(const std::vector<std::string_view>& line) {
    if (line.size() < 2) fail("does not name its format");
    if (line[1] == "ascii")
      header_.format = Format::ascii;
    else if (line[1] == "binary_little_endian")
      header_.format = Format::little_endian;
    else if (line[1] == "binary_big_endian")
      header_.format = Format::big_endian;
    else
      fail("names an unknown format \"" + std::string(line[1].substr(0, 40)) + "\"");
  }

  void read_element(const std::vector<std::string_view>& line) {
    Element element;
    if (line.size() != 3) fail("has a malformed element");
    element.name = line[1];
    const auto [end, error] = std::from_chars(line[2].data(), line[2].data() + line[2].size(), element.count);
    if (error != std::errc() || end != line[2].data() + line[2].size())
      fail("has an element without a valid count");
    header_.elements.push_back(std::move(element));
  }

  void read_property(const std::vector<std::string_view>& line) {
    if (header_.elements.empty()) fail("has a property before the first element");
    Property property;
    if (line.size() == 5 && line[1] == "list") {
      property.list_size = scalar_type(line[2]);
      if (!property.list_size || *property.list_size >= Scalar::float32) fail("has a list of unknown type");
    } else if (line.size() != 3) {
      fail("has a malformed property");
    }
    const auto type = scalar_type(line[line.size() - 2]);
    if (!type) fail("has a property of unknown type");
    property.type = *type;
    property.name = line.back();
    header_.elements.back().properties.push_back(std::move(property));
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t position_ = 0;
  int line_ = 0;
  Header header_;
};

/// Takes one number after the other from the body, whatever its encoding.
class BodyReader {
 public:
  BodyReader(std::string_view body, Format format) : body_(body), format_(format) {}

  std::size_t left() const { return body_.size() - position_; }

  /// @return empty when the file ends here or (ascii) holds something that is no number.
  std::optional<double> next(Scalar type) {
    return format_ == Format::ascii ? next_ascii() : next_binary(type);
  }

 private:
  std::optional<double> next_ascii() {
    while (position_ < body_.size() && std::strchr(" \t\r\n", body_[position_]) != nullptr &&
           body_[position_] != '\0')
      ++position_;
    if (position_ < body_.size() && body_[position_] == '+') ++position_;
    double value = 0.0;
    const char* const begin = body_.data() + position_;
    const auto [end, error] = std::from_chars(begin, body_.data() + body_.size(), value);
    if (error == std::errc::result_out_of_range) {
      // A denormal is as good as zero; an overflow is caught as not finite.
      const bool tiny =
          std::string_view(begin, static_cast<std::size_t>(end - begin)).find("e-") != std::string_view::npos;
      value = tiny ? 0.0 : HUGE_VAL;
    } else if (error != std::errc()) {
      return std::nullopt;
    }
    position_ += static_cast<std::size_t>(end - begin);
    if (position_ < body_.size() && std::strchr(" \t\r\n", body_[position_]) == nullptr) return std::nullopt;
    return value;
  }

  template <class T>
  double decode(const unsigned char* bytes) const {
    unsigned char ordered[sizeof(T)];
    const bool reversed = (format_ == Format::big_endian) == (std::endian::native == std::endian::little);
    for (std::size_t i = 0; i < sizeof(T); ++i) ordered[i] = bytes[reversed ? sizeof(T) - 1 - i : i];
    T value;
    std::memcpy(&value, ordered, sizeof(T));
    return static_cast<double>(value);
  }

  std::optional<double> next_binary(Scalar type) {
    if (left() < size_of(type)) return std::nullopt;
    const auto* bytes = reinterpret_cast<const unsigned char*>(body_.data() + position_);
    position_ += size_of(type);
    switch (type) {
      case Scalar::int8:
        return decode<std::int8_t>(bytes);
      case Scalar::uint8:
        return decode<std::uint8_t>(bytes);
      case Scalar::int16:
        return decode<std::int16_t>(bytes);
      case Scalar::uint16:
        return decode<std::uint16_t>(bytes);
      case Scalar::int32:
        return decode<std::int32_t>(bytes);
      case Scalar::uint32:
        return decode<std::uint32_t>(bytes);
      case Scalar::float32:
        return decode<float>(bytes);
      case Scalar::float64:
        return decode<double>(bytes);
    }
    return std::nullopt;
  }

  std::string_view body_;
  Format format_;
  std::size_t position_ = 0;
};

/// Where in a row of the vertex element what we want stands; -1: absent.
struct Columns {
  int position[3] = {-1, -1, -1};
  int normal[3] = {-1, -1, -1};
  int label = -1, sigma = -1;

  bool has_normals() const { return normal[0] >= 0 && normal[1] >= 0 && normal[2] >= 0; }
};

Columns find_columns(const std::string& file, const Element& vertex) {
  Columns columns;
  static constexpr std::string_view kNames[] = {"x", "y", "z", "nx", "ny", "nz"};
  for (int p = 0; p < static_cast<int>(vertex.properties.size()); ++p) {
    const Property& property = vertex.properties[static_cast<std::size_t>(p)];
    if (property.list_size) continue;
    for (int k = 0; k < 6; ++k)
      if (property.name == kNames[k]) (k < 3 ? columns.position[k] : columns.normal[k - 3]) = p;
    if (property.name == "label") columns.label = p;
    if (property.name == "sigma") columns.sigma = p;
  }
  for (int k = 0; k < 3; ++k)
    if (columns.position[k] < 0)
      throw InputError(file, "vertex", "has no property \"" + std::string(kNames[k]) + "\"", kExport);
  return columns;
}

class CloudReader {
 public:
  CloudReader(std::string file, std::string_view text, double metres)
      : file_(std::move(file)),
        metres_(metres),
        header_(HeaderParser(file_, text).parse()),
        body_(text.substr(header_.body), header_.format) {}

  LabelledCloud read() {
    for (const Element& element : header_.elements) {
      check_count(element);
      if (element.name == "vertex") {
        read_vertices(element);
        return std::move(cloud_);  // what follows (faces) is not ours
      }
      for (std::size_t i = 0; i < element.count; ++i) read_row(element, i);
    }
    throw InputError(file_, "vertex", "is missing: the file holds no points", kExport);
  }

 private:
  /// A count that cannot fit is refused before anything is allocated.
  void check_count(const Element& element) const {
    std::size_t row = 0;
    for (const Property& p : element.properties)
      row += header_.format == Format::ascii ? 1 : size_of(p.list_size ? *p.list_size : p.type);
    if (row == 0 && element.count > 0)
      throw InputError(file_, element.name, "has rows but no properties", kExport);
    if (row > 0 && element.count > body_.left() / row + 1) truncated(element, body_.left() / row);
  }

  [[noreturn]] void truncated(const Element& element, std::size_t row) const {
    throw InputError(file_, element.name + " " + std::to_string(row),
                     "is where the file breaks off or stops being numbers, of " +
                         std::to_string(element.count) + " announced",
                     "The file is truncated or damaged: copy or export it again");
  }

  void read_row(const Element& element, std::size_t row) {
    values_.clear();
    for (const Property& property : element.properties) {
      if (property.list_size) {
        const auto length = body_.next(*property.list_size);
        if (!length || !(*length >= 0.0) || *length > static_cast<double>(body_.left()) ||
            *length != std::floor(*length))
          truncated(element, row);
        for (auto k = static_cast<std::size_t>(*length); k > 0; --k)
          if (!body_.next(property.type)) truncated(element, row);
        values_.push_back(0.0);
        continue;
      }
      const auto value = body_.next(property.type);
      if (!value) truncated(element, row);
      values_.push_back(*value);
    }
  }

  void read_vertices(const Element& vertex) {
    if (vertex.count == 0)
      throw InputError(file_, "vertex", "the cloud has no points", "Reconstruct or export it again");
    const Columns columns = find_columns(file_, vertex);
    const auto n = static_cast<Eigen::Index>(vertex.count);
    cloud_.points.resize(n, 3);
    if (columns.has_normals()) cloud_.normals.resize(n, 3);
    for (std::size_t i = 0; i < vertex.count; ++i) {
      read_row(vertex, i);
      take_row(columns, i);
    }
  }

  double value(int column) const { return values_[static_cast<std::size_t>(column)]; }

  void take_row(const Columns& columns, std::size_t row) {
    const auto i = static_cast<Eigen::Index>(row);
    const std::string name = "vertex " + std::to_string(row);
    for (int k = 0; k < 3; ++k) cloud_.points(i, k) = metres_ * value(columns.position[k]);
    if (!cloud_.points.row(i).allFinite())
      throw InputError(file_, name, "has a coordinate that is not a number",
                       "Remove the point or export the cloud again");
    if (columns.has_normals()) {
      const Eigen::RowVector3d normal(value(columns.normal[0]), value(columns.normal[1]),
                                      value(columns.normal[2]));
      const double length = normal.stableNorm();
      if (!std::isfinite(length) || length < 1e-12)
        throw InputError(file_, name, "has a normal without a direction",
                         "Compute the normals again or leave nx ny nz out");
      cloud_.normals.row(i) = normal / length;
    }
    if (columns.label >= 0) take_label(name, value(columns.label));
    if (columns.sigma >= 0) {
      const double sigma = metres_ * value(columns.sigma);
      if (!std::isfinite(sigma) || sigma < 0.0)
        throw InputError(file_, name, "has a sigma that is no standard deviation",
                         "It must be a number of 0 or more");
      cloud_.sigma.push_back(sigma);
    }
  }

  void take_label(const std::string& name, double label) {
    if (label != 1.0 && label != 2.0 && label != 3.0) {
      std::string text = std::to_string(label);
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
      throw InputError(file_, name, "has the label " + text + ", which is none",
                       "Labels are 1 (surface), 2 (anterior margin) and 3 (umbilical notch)");
    }
    cloud_.features.push_back(static_cast<Feature>(static_cast<int>(label)));
  }

  std::string file_;
  double metres_;
  Header header_;
  BodyReader body_;
  std::vector<double> values_;
  LabelledCloud cloud_;
};

template <class T>
void append(std::string& to, T value) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i)
    to.push_back(
        static_cast<char>(bytes[std::endian::native == std::endian::little ? i : sizeof(T) - 1 - i]));
}

}  // namespace

LabelledCloud read_cloud(const std::filesystem::path& path, LengthUnit unit) {
  const std::string text = read_file(path);
  return CloudReader(path.string(), text, metres_per(unit)).read();
}

void write_cloud(const std::filesystem::path& path, const LabelledCloud& cloud, LengthUnit unit) {
  const auto n = static_cast<std::size_t>(cloud.size());
  const bool has_normals = cloud.normals.rows() > 0;
  require(!has_normals || cloud.normals.rows() == cloud.points.rows(), "a cloud has a normal for each point");
  require(cloud.features.empty() || cloud.features.size() == n, "a cloud has a label for each point");
  require(cloud.sigma.empty() || cloud.sigma.size() == n, "a cloud has a sigma for each point");
  require(cloud.points.allFinite(), "the points of a cloud are finite");

  std::string text = "ply\nformat binary_little_endian 1.0\ncomment Glisson, left camera's frame, ";
  text += unit == LengthUnit::millimetre ? "mm" : unit == LengthUnit::centimetre ? "cm" : "m";
  text +=
      "\nelement vertex " + std::to_string(n) + "\nproperty double x\nproperty double y\nproperty double z\n";
  if (has_normals) text += "property float nx\nproperty float ny\nproperty float nz\n";
  text += "property uchar label\n";
  if (!cloud.sigma.empty()) text += "property float sigma\n";
  text += "end_header\n";
  const double scale = 1.0 / metres_per(unit);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (int k = 0; k < 3; ++k) append(text, scale * cloud.points(row, k));
    if (has_normals)
      for (int k = 0; k < 3; ++k) append(text, static_cast<float>(cloud.normals(row, k)));
    append(text, static_cast<std::uint8_t>(cloud.feature(static_cast<int>(i))));
    if (!cloud.sigma.empty()) append(text, static_cast<float>(scale * cloud.sigma[i]));
  }
  write_file_atomically(path, text);
}

}  // namespace glisson
