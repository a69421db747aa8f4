// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>

#include "glisson/core/error.h"
#include "mesh_bytes.h"
#include "mesh_io_cells.h"
#include "text_scanner.h"

/// @file
/// Legacy .vtk by our own parser (VTK file formats, versions 1 to 5.1): VTK's crashes on cell lists whose
/// counts do not fit (vtkCellArray::AppendLegacyFormat, 9.1).

namespace glisson::formats {
namespace {

enum class Kind { bits, signed_integer, unsigned_integer, real };
struct Type {
  Kind kind;
  std::size_t size;  ///< bytes in a binary file
};

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Names hold "%20" for a space.
std::string decoded(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(name.data() + i + 1, name.data() + i + 3, code, 16).ptr == name.data() + i + 3) {
      text += static_cast<char>(code);
      i += 2;
    } else {
      text += name[i];
    }
  }
  return text;
}

class LegacyParser {
 public:
  LegacyParser(const std::string& content, std::filesystem::path path)
      : scan_(content, path.string()), path_(std::move(path)) {}

  MixedFile parse() {
    read_header();
    for (std::string key = upper(scan_.token()); !key.empty(); key = upper(scan_.token())) read_section(key);
    if (points_.rows() == 0) scan_.fail("has no points");
    if (!types_.empty() && types_.size() != lists_.size())
      scan_.fail("has " + std::to_string(lists_.size()) + " cells and " + std::to_string(types_.size()) +
                 " cell types");
    if (grid_ && types_.empty() && !lists_.empty()) scan_.fail("has cells without CELL_TYPES");
    CellSorter cells(path_, points_.rows());
    for (std::size_t c = 0; c < lists_.size(); ++c) cells.add(grid_ ? types_[c] : list_types_[c], lists_[c]);
    return cells.finish(points_, point_data_, cell_data_, field_data_);
  }

 private:
  void read_header() {
    std::string_view line;
    if (!scan_.next_line(line) || line.rfind("# vtk DataFile Version", 0) != 0)
      throw InputError(path_.string(), "line 1", "is not a legacy VTK file (no \"# vtk DataFile Version\")",
                       "Choose another file");
    if (!TextScanner::parse(line.substr(line.find_last_of(' ') + 1), version_)) version_ = 3.0;
    scan_.next_line(line);  // the title
    const std::string encoding = upper(scan_.token());
    if (encoding != "ASCII" && encoding != "BINARY") scan_.fail("is neither ASCII nor BINARY");
    binary_ = encoding == "BINARY";
  }

  void read_section(const std::string& key) {
    if (key == "DATASET") {
      const std::string type = upper(scan_.token());
      if (type != "POLYDATA" && type != "UNSTRUCTURED_GRID")
        scan_.fail("holds a " + type + ", neither POLYDATA nor UNSTRUCTURED_GRID");
      grid_ = type == "UNSTRUCTURED_GRID";
    } else if (key == "POINTS") {
      const long count = scan_.integer();
      const std::vector<double> values = numbers(checked(count, 3), scan_.token());
      points_ = Eigen::Map<const Points>(values.data(), count, 3);
    } else if (key == "CELLS") {
      read_cells(0);
    } else if (key == "VERTICES") {
      read_cells(2);
    } else if (key == "LINES") {
      read_cells(4);
    } else if (key == "POLYGONS") {
      read_cells(7);
    } else if (key == "TRIANGLE_STRIPS") {
      read_cells(6);
    } else if (key == "CELL_TYPES") {
      types_ = whole_numbers(checked(scan_.integer(), 1), "int");
    } else if (key == "POINT_DATA") {
      attributes_ = &point_data_;
      attribute_rows_ = checked(scan_.integer(), 1);
    } else if (key == "CELL_DATA") {
      attributes_ = &cell_data_;
      attribute_rows_ = checked(scan_.integer(), 1);
    } else if (key == "METADATA") {
      skip_metadata();
    } else {
      read_array(key);
    }
  }

  void skip_metadata() {
    std::string_view line;
    scan_.next_line(line);
    while (scan_.next_line(line) && !line.empty()) {
    }
  }

  void read_array(const std::string& key) {
    if (key == "FIELD") {
      scan_.token();
      const long count = scan_.count(1);
      for (long i = 0; i < count; ++i) read_field_array();
    } else if (key == "SCALARS") {
      read_scalars();
    } else if (key == "LOOKUP_TABLE") {
      scan_.token();
      numbers(checked(scan_.integer(), 4), binary_ ? "unsigned_char" : "float");
    } else if (key == "COLOR_SCALARS") {
      const std::string name = decoded(scan_.token());
      keep(name, scan_.integer(), binary_ ? "unsigned_char" : "float");
    } else if (key == "VECTORS" || key == "NORMALS" || key == "TENSORS" || key == "TENSORS6" ||
               key == "GLOBAL_IDS" || key == "PEDIGREE_IDS") {
      const std::string name = decoded(scan_.token());
      const long width = key == "TENSORS"                       ? 9
                         : key == "TENSORS6"                    ? 6
                         : key == "VECTORS" || key == "NORMALS" ? 3
                                                                : 1;
      keep(name, width, scan_.token());
    } else if (key == "TEXTURE_COORDINATES") {
      const std::string name = decoded(scan_.token());
      const long width = scan_.integer();
      keep(name, width, scan_.token());
    } else {
      scan_.fail("unknown section \"" + key.substr(0, 40) + "\"");
    }
  }

  void read_field_array() {
    std::string_view word = scan_.token();
    while (upper(word) == "METADATA") {
      skip_metadata();
      word = scan_.token();
    }
    const std::string name = decoded(word);
    const long width = scan_.integer(), rows = scan_.integer();
    const long count = checked(rows, width);
    const std::string_view type = scan_.token();
    if (type == "string") {
      std::string_view line;
      scan_.next_line(line);
      if (binary_) scan_.fail("holds an array of strings; remove it (\"" + name + "\")");
      for (long i = 0; i < count; ++i) scan_.next_line(line);
      return;
    }
    const Eigen::MatrixXd values = matrix(numbers(count, type), rows, width);
    (attributes_ != nullptr ? *attributes_ : field_data_)[name] = values;
  }

  void read_scalars() {
    const std::string name = decoded(scan_.token());
    const std::string type(scan_.token());
    std::string_view rest;
    scan_.next_line(rest);
    long width = 1;
    TextScanner words(rest, path_.string());
    const std::string_view word = words.token();
    if (!word.empty() && !TextScanner::parse(word, width)) scan_.fail("SCALARS have no number of components");
    if (upper(scan_.token()) != "LOOKUP_TABLE") scan_.fail("SCALARS have no LOOKUP_TABLE");
    scan_.token();
    keep(name, width, type);
  }

  void keep(const std::string& name, long width, std::string_view type) {
    if (attributes_ == nullptr) scan_.fail("an array stands before POINT_DATA and CELL_DATA");
    (*attributes_)[name] = matrix(numbers(checked(attribute_rows_, width), type), attribute_rows_, width);
  }

  static Eigen::MatrixXd matrix(const std::vector<double>& values, long rows, long width) {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(values.data(), rows, width);
  }

  /// @param type 0: by CELL_TYPES.
  void read_cells(int type) {
    const long first = scan_.integer(), second = scan_.integer();
    if (first > kMostRows) scan_.fail("announces more cells than the mesh of an organ needs");
    std::vector<long> offsets, connectivity;
    if (version_ >= 5.0) {  // OFFSETS and CONNECTIVITY
      if (first == 0) return;
      if (upper(scan_.token()) != "OFFSETS") scan_.fail("cells have no OFFSETS");
      offsets = whole_numbers(checked(first, 1), scan_.token());
      if (upper(scan_.token()) != "CONNECTIVITY") scan_.fail("cells have no CONNECTIVITY");
      connectivity = whole_numbers(checked(second, 1), scan_.token());
    } else {  // a count before each list
      const std::vector<long> values = whole_numbers(checked(second, 1), "int");
      offsets.push_back(0);
      for (auto at = values.begin(); at != values.end();) {
        const long length = *at++;
        if (length == 0) scan_.fail("cell " + std::to_string(offsets.size() - 1) + " has no points");
        if (length < 0 || length > values.end() - at)
          scan_.fail("cell " + std::to_string(offsets.size() - 1) + " has a list longer than the section");
        connectivity.insert(connectivity.end(), at, at + length);
        offsets.push_back(static_cast<long>(connectivity.size()));
        at += length;
      }
      if (static_cast<long>(offsets.size()) - 1 != first)
        scan_.fail("announces " + std::to_string(first) + " cells and holds " +
                   std::to_string(offsets.size() - 1));
    }
    for (std::size_t c = 1; c < offsets.size(); ++c) {
      const long begin = offsets[c - 1], end = offsets[c];
      if (begin < 0 || begin >= end || end > static_cast<long>(connectivity.size()))
        scan_.fail("cell " + std::to_string(c - 1) + " has offsets out of range");
      lists_.emplace_back(connectivity.begin() + begin, connectivity.begin() + end);
      list_types_.push_back(type);
    }
  }

  /// rows * width, if the file can hold so many numbers.
  long checked(long rows, long width) const {
    const auto most = static_cast<long>(scan_.remaining()) * 8 + 8;  // bits are the smallest
    if (rows < 0 || width < 0 || (width > 0 && rows > most / width))
      scan_.fail("announces more numbers than the file holds");
    if (width > 0 && rows > 12 * kMostRows / width) scan_.fail("announces more numbers than a mesh needs");
    return rows * width;
  }

  Type type_of(std::string_view name) const {
    static constexpr std::pair<const char*, Type> kTypes[] = {
        {"bit", {Kind::bits, 0}},
        {"char", {Kind::signed_integer, 1}},
        {"signed_char", {Kind::signed_integer, 1}},
        {"unsigned_char", {Kind::unsigned_integer, 1}},
        {"short", {Kind::signed_integer, 2}},
        {"unsigned_short", {Kind::unsigned_integer, 2}},
        {"int", {Kind::signed_integer, 4}},
        {"unsigned_int", {Kind::unsigned_integer, 4}},
        {"vtkidtype", {Kind::signed_integer, 4}},  // written as int whatever its size
        {"long", {Kind::signed_integer, 8}},
        {"unsigned_long", {Kind::unsigned_integer, 8}},
        {"vtktypeint64", {Kind::signed_integer, 8}},
        {"vtktypeuint64", {Kind::unsigned_integer, 8}},
        {"float", {Kind::real, 4}},
        {"double", {Kind::real, 8}}};
    const std::string lower = lower_case(std::string(name));
    for (const auto& [known, type] : kTypes)
      if (lower == known) return type;
    scan_.fail("unknown number type \"" + std::string(name.substr(0, 40)) + "\"");
  }

  static double decode(const char* bytes, Type type) {
    std::uint64_t raw = 0;  // big-endian in the file
    for (std::size_t i = 0; i < type.size; ++i) raw = raw << 8 | static_cast<unsigned char>(bytes[i]);
    if (type.kind == Kind::real)
      return type.size == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)))
                            : std::bit_cast<double>(raw);
    if (type.kind == Kind::unsigned_integer) return static_cast<double>(raw);
    const auto unused = 64 - 8 * std::clamp(static_cast<int>(type.size), 1, 8);
    return static_cast<double>(static_cast<std::int64_t>(raw << unused) >> unused);
  }

  std::vector<double> numbers(long count, std::string_view type_name) {
    const Type type = type_of(type_name);
    std::vector<double> values;
    if (!binary_) {
      if (count > static_cast<long>(scan_.remaining()))
        scan_.fail("announces more numbers than the file holds");
      values.reserve(static_cast<std::size_t>(count));
      for (long i = 0; i < count; ++i) values.push_back(scan_.number());
      return values;
    }
    std::string_view rest;
    scan_.next_line(rest);  // the data begin after the keyword's line
    const auto wanted = static_cast<std::size_t>(count);
    const std::size_t size = type.kind == Kind::bits ? (wanted + 7) / 8 : wanted * type.size;
    const std::string_view bytes = scan_.raw(size);
    values.reserve(wanted);
    for (std::size_t i = 0; i < wanted; ++i)
      values.push_back(type.kind == Kind::bits ? (static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8)) & 1
                                               : decode(bytes.data() + i * type.size, type));
    return values;
  }

  /// Where a point, a type or a length of a list is meant.
  std::vector<long> whole_numbers(long count, std::string_view type_name) {
    std::vector<long> whole;
    for (const double value : numbers(count, type_name)) {
      if (!(std::abs(value) < 1e15) || value != std::trunc(value))
        scan_.fail("the cells hold a number that is not whole or far too large");
      whole.push_back(static_cast<long>(value));
    }
    return whole;
  }

  TextScanner scan_;
  std::filesystem::path path_;
  double version_ = 3.0;
  bool binary_ = false, grid_ = false;
  Points points_;
  std::vector<std::vector<long>> lists_;
  std::vector<long> list_types_, types_;
  NamedArrays point_data_, cell_data_, field_data_;
  NamedArrays* attributes_ = nullptr;
  long attribute_rows_ = 0;
};

}  // namespace

MixedFile read_legacy_vtk(const std::filesystem::path& path) {
  const std::string content = mesh_bytes(path);
  return LegacyParser(content, path).parse();
}

}  // namespace glisson::formats
