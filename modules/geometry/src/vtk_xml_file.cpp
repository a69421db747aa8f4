// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/vtk_xml_file.h"

#include <zlib.h>

#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "glisson/core/error.h"
#include "mesh_bytes.h"
#include "text_scanner.h"
#include "vtk_cell_types.h"
#include "vtk_xml_bytes.h"
#include "xml_scanner.h"

namespace glisson {
namespace {

using vtk_xml::ByteSource;
using vtk_xml::Number;
using vtk_xml::number_named;

constexpr const char* kExport = "The file is damaged, or its exporter is: export it anew";
constexpr long kMost = std::numeric_limits<int>::max();
constexpr std::size_t kMostBytes =
    600000000;  // of all arrays as they are held: organs' meshes have a tenth of it
constexpr std::size_t kMostPacking = 1100;  // deflate packs to 1/1032 at the best

/// A DataArray as it stands in the file.
struct Array {
  std::string name, type, format, line;
  long components = 1, tuples = -1;
  std::string text;
  std::size_t offset = 0;
  std::string field() const { return name.empty() ? line : name; }
};

struct Piece {
  long points = 0, cells = 0, verts = 0, lines = 0, strips = 0, polys = 0;
  std::map<std::string, std::vector<Array>> sections;  ///< by the enclosing element
};

class VtkXmlParser {
 public:
  VtkXmlParser(std::string_view content, const std::string& name)
      : content_(content), name_(name), scan_(content, name) {}

  VtkXmlFile parse() {
    read_elements();
    if (pieces_.empty()) refuse("Piece", "is missing");
    VtkXmlFile file;
    for (const Array& array : field_data_)
      if (number_named(array.type)) file.field_data[array.name] = matrix_of(array, array.tuples);
    double points = 0.0, cells = 0.0;
    for (const Piece& piece : pieces_) {
      points += static_cast<double>(piece.points);
      cells += static_cast<double>(piece.cells) + static_cast<double>(piece.verts) +
               static_cast<double>(piece.lines) + static_cast<double>(piece.strips) +
               static_cast<double>(piece.polys);
    }
    check_rows(name_, "NumberOfPoints", points);
    check_rows(name_, "NumberOfCells", cells);
    file.points.resize(0, 3);
    for (const Piece& piece : pieces_) add(piece, file);
    return file;
  }

 private:
  [[noreturn]] void refuse(const std::string& field, const std::string& problem,
                           const std::string& remedy = kExport) const {
    throw InputError(name_, field, problem, remedy);
  }

  // What the file says

  using Attributes = std::map<std::string, std::string>;
  static std::string value(const Attributes& attributes, const char* key) {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string() : found->second;
  }
  long count(const Attributes& attributes, const char* key, long otherwise) const {
    const std::string text = value(attributes, key);
    if (text.empty()) return otherwise;
    long number = -1;
    TextScanner words(text, name_);
    if (!TextScanner::parse(words.token(), number) || !words.token().empty() || number < 0 || number > kMost)
      refuse(key, "is \"" + text.substr(0, 40) + "\", which is no count");
    return number;
  }

  void read_elements() {
    for (XmlScanner::Token token = scan_.next(); token.kind != XmlScanner::Kind::end; token = scan_.next()) {
      if (token.kind == XmlScanner::Kind::text) continue;
      if (token.kind == XmlScanner::Kind::close) {
        if (open_.empty() || open_.back() != token.name)
          scan_.fail("closes " + token.name.substr(0, 40) + ", which is not open");
        open_.pop_back();
        continue;
      }
      if (open_.empty() && token.name != "VTKFile") refuse("VTKFile", "is missing: this is no VTK file");
      if (open_.size() > 16) scan_.fail("elements lie in elements too deeply");
      take(token);
      if (token.name == "AppendedData") return;                           // nothing of use comes behind it
      if (!token.empty && !is_array(token)) open_.push_back(token.name);  // an array was read to its end
    }
    if (!open_.empty()) scan_.fail("ends inside " + open_.back());
  }

  static bool is_array(const XmlScanner::Token& token) {
    return token.name == "DataArray" || token.name == "Array";
  }

  void take(const XmlScanner::Token& token) {
    const Attributes& a = token.attributes;
    if (token.name == "VTKFile") {
      read_kind(a);
    } else if (token.name == "Piece") {
      Piece piece;
      piece.points = count(a, "NumberOfPoints", 0);
      piece.cells = count(a, "NumberOfCells", 0);
      piece.verts = count(a, "NumberOfVerts", 0);
      piece.lines = count(a, "NumberOfLines", 0);
      piece.strips = count(a, "NumberOfStrips", 0);
      piece.polys = count(a, "NumberOfPolys", 0);
      pieces_.push_back(std::move(piece));
    } else if (is_array(token)) {
      take_array(token);
    } else if (token.name == "AppendedData") {
      take_appended(token);
    }
  }

  void read_kind(const Attributes& a) {
    kind_ = value(a, "type");
    if (kind_ != "UnstructuredGrid" && kind_ != "PolyData")
      refuse("type", "is \"" + kind_.substr(0, 40) + "\", neither UnstructuredGrid nor PolyData",
             "Choose another file");
    big_ = value(a, "byte_order") == "BigEndian";
    const std::string header = value(a, "header_type");
    if (!header.empty() && header != "UInt32" && header != "UInt64")
      refuse("header_type", "is none that is known");
    wide_ = header == "UInt64";
    const std::string compressor = value(a, "compressor");
    packed_ = !compressor.empty();
    if (packed_ && compressor != "vtkZLibDataCompressor")
      refuse("compressor", "is \"" + compressor.substr(0, 40) + "\", which is not read",
             "Save it packed by ZLib, or plain");
  }

  void take_array(const XmlScanner::Token& token) {
    Array array;
    array.name = value(token.attributes, "Name");
    array.type = value(token.attributes, "type");
    array.format = value(token.attributes, "format");
    array.line = open_.empty() ? token.name : open_.back();
    array.components = std::max(1L, count(token.attributes, "NumberOfComponents", 1));
    array.tuples = count(token.attributes, "NumberOfTuples", -1);
    if (array.format == "appended") {
      const std::string offset = value(token.attributes, "offset");
      if (!TextScanner::parse(std::string_view(offset), array.offset)) refuse(array.field(), "has no offset");
    } else if (array.format != "ascii" && array.format != "binary") {
      refuse(array.field(), "has the format \"" + array.format.substr(0, 40) + "\", which is none");
    }
    if (!token.empty) read_array_text(token.name, array);
    const std::string section = open_.empty() ? "" : open_.back();
    if (section == "FieldData")
      field_data_.push_back(std::move(array));
    else if (!pieces_.empty())
      pieces_.back().sections[section].push_back(std::move(array));
  }

  /// Up to its end tag; what lies in it (information keys) is passed over.
  void read_array_text(const std::string& tag, Array& array) {
    for (int depth = 1; depth > 0;) {
      const XmlScanner::Token inner = scan_.next();
      if (inner.kind == XmlScanner::Kind::end) scan_.fail("ends inside an array");
      if (inner.kind == XmlScanner::Kind::text && depth == 1) array.text += inner.text;
      if (inner.kind == XmlScanner::Kind::open && !inner.empty) ++depth;
      if (inner.kind == XmlScanner::Kind::close) --depth;
      if (depth == 0 && inner.name != tag) scan_.fail("an array is closed by another element");
      if (depth > 16) scan_.fail("elements lie in elements too deeply");
    }
  }

  void take_appended(const XmlScanner::Token& token) {
    const std::string encoding = value(token.attributes, "encoding");
    if (encoding != "raw" && encoding != "base64") refuse("AppendedData", "has an encoding that is none");
    base64_ = encoding == "base64";
    const std::size_t mark = content_.find('_', scan_.position());
    const std::size_t end = content_.rfind("</AppendedData>");
    if (token.empty || mark == std::string_view::npos || end == std::string_view::npos || end < mark)
      refuse("AppendedData", "has no beginning or no end");
    appended_ = content_.substr(mark + 1, end - mark - 1);
  }

  // What arrays hold

  std::uint64_t header_word(ByteSource& source, const Array& array) const {
    std::string bytes;
    if (!source.take(wide_ ? 8 : 4, bytes)) refuse(array.field(), "ends early");
    if (big_) std::reverse(bytes.begin(), bytes.end());
    std::uint64_t word = 0;
    static_assert(std::endian::native == std::endian::little);
    std::memcpy(&word, bytes.data(), bytes.size());
    return word;
  }

  /// Counts what arrays hold together: many may name the same bytes, and packed ones may hold a thousand
  /// times their size.
  void spend(const Array& array, std::size_t bytes, std::size_t most) {
    const std::size_t numbers = bytes / vtk_xml::size_of(number_named(array.type).value_or(Number::i8));
    if (numbers > most)
      refuse(array.field(), "holds " + std::to_string(numbers) + " numbers or more where " +
                                std::to_string(most) + " are announced");
    const std::size_t held = numbers * sizeof(double);
    if (held > kMostBytes - spent_)
      refuse(array.field(), "holds more than a mesh does, with the arrays before it");
    spent_ += held;
  }

  std::string bytes_of(const Array& array, std::size_t most) {
    const bool appended = array.format == "appended";
    if (appended && array.offset > appended_.size()) refuse(array.field(), "lies beyond the file's end");
    ByteSource source(appended ? appended_.substr(array.offset) : std::string_view(array.text),
                      !appended || base64_);
    if (packed_) return unpacked(source, array, most);
    const std::uint64_t size = header_word(source, array);
    spend(array, static_cast<std::size_t>(std::min<std::uint64_t>(size, source.remaining())), most);
    std::string bytes;
    if (size > source.remaining() || !source.take(static_cast<std::size_t>(size), bytes))
      refuse(array.field(), "ends early, or is no base64");
    return bytes;
  }

  /// Number of blocks, size of a block, of the last one (0: a whole one), packed size of each; then the
  /// blocks.
  std::string unpacked(ByteSource& source, const Array& array, std::size_t most) {
    const std::uint64_t blocks = header_word(source, array);
    if (blocks == 0) return {};
    const std::uint64_t whole = header_word(source, array), last = header_word(source, array);
    if (blocks > source.remaining() / 4 || whole > (1ULL << 40) || last > whole)
      refuse(array.field(), "announces more blocks than the file holds");
    std::vector<std::uint64_t> sizes(static_cast<std::size_t>(blocks));
    for (std::uint64_t& size : sizes) size = header_word(source, array);
    // Before a block is unpacked: of small ones there may be many.
    const double all = static_cast<double>(blocks - 1) * static_cast<double>(whole) +
                       static_cast<double>(last > 0 ? last : whole);
    spend(array, static_cast<std::size_t>(std::min(all, 1e15)), most);
    std::string bytes, packed, block;
    for (std::size_t b = 0; b < sizes.size(); ++b) {
      const std::uint64_t size = b + 1 == sizes.size() && last > 0 ? last : whole;
      if (sizes[b] > source.remaining() || !source.take(static_cast<std::size_t>(sizes[b]), packed))
        refuse(array.field(), "ends early, or is no base64");
      if (size > kMostPacking * packed.size())
        refuse(array.field(), "announces a block larger than it can be");
      block.resize(static_cast<std::size_t>(size));
      uLongf length = static_cast<uLongf>(block.size());
      if (::uncompress(reinterpret_cast<Bytef*>(block.data()), &length,
                       reinterpret_cast<const Bytef*>(packed.data()),
                       static_cast<uLong>(packed.size())) != Z_OK ||
          length != block.size())
        refuse(array.field(), "holds a packed block that is damaged");
      bytes += block;
    }
    return bytes;
  }

  /// @param most refused as soon as there are more: an array's length is known from what it belongs to.
  std::vector<double> values_of(const Array& array, std::size_t most = std::size_t{1} << 40) {
    const std::optional<Number> number = number_named(array.type);
    if (!number)
      refuse(array.field(), "has the type \"" + array.type.substr(0, 40) + "\", which is no number's");
    std::vector<double> values;
    if (array.format == "ascii") {
      TextScanner words(array.text, name_);
      for (std::string_view word = words.token(); !word.empty(); word = words.token()) {
        double one = 0.0;
        if (!TextScanner::parse(word, one))
          refuse(array.field(), "holds \"" + std::string(word.substr(0, 40)) + "\", which is no number");
        if (values.size() % 1000 == 0) spend(array, 1000 * vtk_xml::size_of(*number), 1000 + most);
        values.push_back(one);
      }
      return values;
    }
    std::string bytes = bytes_of(array, most);
    const std::size_t size = vtk_xml::size_of(*number);
    if (bytes.size() % size != 0) refuse(array.field(), "ends inside a number");
    values.reserve(bytes.size() / size);
    for (std::size_t at = 0; at < bytes.size(); at += size) {
      if (big_)
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
      values.push_back(vtk_xml::decode(reinterpret_cast<const unsigned char*>(bytes.data()) + at, *number));
    }
    return values;
  }

  /// @param rows as many as there must be; negative: as many as there are.
  Eigen::MatrixXd matrix_of(const Array& array, long rows) {
    const std::vector<double> values =
        rows < 0 ? values_of(array) : values_of(array, static_cast<std::size_t>(rows * array.components));
    const auto size = static_cast<long>(values.size());
    if (rows < 0) rows = size / array.components;
    if ((array.components > 0 && rows > kMost / array.components) || rows * array.components != size)
      refuse(array.field(), "holds " + std::to_string(size) + " numbers where " + std::to_string(rows) +
                                " times " + std::to_string(array.components) + " are announced");
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(values.data(), rows, array.components);
  }

  /// Where a point, a type or a place in a list is meant.
  std::vector<long> whole_numbers(const Array& array, std::size_t most = std::size_t{1} << 40) {
    std::vector<long> whole;
    for (const double value : values_of(array, most)) {
      if (!(value >= 0.0 && value < 1e15) || value != std::trunc(value))
        refuse(array.field(), "holds a number that is not whole, negative or far too large");
      whole.push_back(static_cast<long>(value));
    }
    return whole;
  }

  // What they mean

  const Array* array_in(const Piece& piece, const char* section, const char* name) const {
    const auto found = piece.sections.find(section);
    if (found == piece.sections.end()) return nullptr;
    for (const Array& array : found->second)
      if (array.name == name || *name == '\0') return &array;
    return nullptr;
  }

  void add(const Piece& piece, VtkXmlFile& file) {
    const long offset = file.points.rows();
    const auto cells_before = static_cast<long>(file.cells.size());
    const Array* points = array_in(piece, "Points", "");
    if (piece.points > 0) {
      if (points == nullptr) refuse("Points", "are missing");
      if (points->components != 3) refuse("Points", "have not three coordinates each");
      const Eigen::MatrixXd more = matrix_of(*points, piece.points);
      file.points.conservativeResize(offset + piece.points, 3);
      file.points.bottomRows(piece.points) = more;
    }
    if (kind_ == "UnstructuredGrid") {
      add_cells(piece, "Cells", piece.cells, 0, offset, file);
    } else {
      add_cells(piece, "Verts", piece.verts, vtk_cell::kPolyVertex, offset, file);
      add_cells(piece, "Lines", piece.lines, vtk_cell::kPolyLine, offset, file);
      add_cells(piece, "Polys", piece.polys, vtk_cell::kPolygon, offset, file);
      add_cells(piece, "Strips", piece.strips, vtk_cell::kStrip, offset, file);
    }
    append(piece, "PointData", piece.points, offset == 0, file.point_data);
    append(piece, "CellData", static_cast<long>(file.cells.size()) - cells_before, cells_before == 0,
           file.cell_data);
  }

  /// @param type 0: each has its own.
  void add_cells(const Piece& piece, const char* section, long count, int type, long first_point,
                 VtkXmlFile& file) {
    if (count == 0) return;
    const Array* connectivity = array_in(piece, section, "connectivity");
    const Array* offsets = array_in(piece, section, "offsets");
    const Array* types = array_in(piece, section, "types");
    if (connectivity == nullptr || offsets == nullptr || (type == 0 && types == nullptr))
      refuse(section, "have no connectivity, offsets or types");
    const auto most = static_cast<std::size_t>(count);
    const std::vector<long> corners = whole_numbers(*connectivity), ends = whole_numbers(*offsets, most),
                            kinds = type == 0 ? whole_numbers(*types, most) : std::vector<long>();
    if (static_cast<long>(ends.size()) != count || (type == 0 && static_cast<long>(kinds.size()) != count))
      refuse(section, "hold " + std::to_string(ends.size()) + " offsets where " + std::to_string(count) +
                          " cells are announced");
    long begin = 0;
    for (std::size_t c = 0; c < ends.size(); ++c) {
      const std::string field = std::string(section) + ", cell " + std::to_string(c);
      if (ends[c] < begin || ends[c] > static_cast<long>(corners.size()))
        refuse(field, "has offsets out of range");
      if (ends[c] == begin) refuse(field, "has no points");
      std::vector<long> cell(corners.begin() + begin, corners.begin() + ends[c]);
      for (long& corner : cell) {
        if (corner >= piece.points) refuse(field, "names a point that is not there");
        corner += first_point;
      }
      if (type == 0 && kinds[c] > 255) refuse(field, "has a type that is none");
      file.cells.push_back(std::move(cell));
      file.cell_types.push_back(type == 0 ? static_cast<int>(kinds[c]) : type);
      begin = ends[c];
    }
  }

  /// Arrays that every piece has, in the same width, go on; others end.
  void append(const Piece& piece, const char* section, long rows, bool first, NamedArrays& arrays) {
    if (rows == 0 && !first) return;
    NamedArrays here;
    if (const auto found = piece.sections.find(section); found != piece.sections.end())
      for (const Array& array : found->second)
        if (!array.name.empty() && number_named(array.type)) here[array.name] = matrix_of(array, rows);
    if (first) {
      arrays = std::move(here);
      return;
    }
    std::erase_if(arrays, [&](const auto& one) {
      const auto more = here.find(one.first);
      return more == here.end() || more->second.cols() != one.second.cols();
    });
    for (auto& [name, values] : arrays) {
      const Eigen::MatrixXd& more = here.at(name);
      values.conservativeResize(values.rows() + more.rows(), Eigen::NoChange);
      values.bottomRows(more.rows()) = more;
    }
  }

  std::string_view content_;
  std::string name_;
  XmlScanner scan_;
  std::string kind_;
  bool big_ = false, wide_ = false, packed_ = false, base64_ = false;
  std::vector<std::string> open_;
  std::vector<Piece> pieces_;
  std::vector<Array> field_data_;
  std::string_view appended_;
  std::size_t spent_ = 0;  ///< bytes, see spend()
};

}  // namespace

VtkXmlFile parse_vtk_xml(std::string_view content, const std::string& name) {
  return VtkXmlParser(content, name).parse();
}

VtkXmlFile read_vtk_xml(const std::filesystem::path& path) {
  return parse_vtk_xml(mesh_bytes(path), path.string());
}

}  // namespace glisson
