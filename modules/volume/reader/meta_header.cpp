// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <sstream>

#include "claim.h"
#include "header_lines.h"

/// @file
/// A MetaImage's header (https://itk.org/Wiki/MetaIO/Documentation), as far as a patient's volume needs it.

namespace glisson::reader {
namespace {

constexpr std::size_t kLongestHeader = 1U << 16;

struct Header {
  std::map<std::string, std::string> keys;
  std::uintmax_t end = 0;  ///< where local data begin
};

constexpr HeaderRefusal refuse{"Export the volume again, as one .mha file"};

/// "key = value" lines up to ElementDataFile, which ends the header.
Header header_of(const Request& request) {
  HeaderLines lines(request, kLongestHeader);
  Header header;
  std::string line;
  while (lines.next(line)) {
    header.end = lines.end();
    const std::size_t equals = line.find('=');
    // The library reads on behind a broken line, with its defaults for what the line has said.
    if (equals == std::string::npos && line.find_first_not_of(" \t") != std::string::npos)
      refuse(request, line.substr(0, 40), "is no field of a header");
    if (equals == std::string::npos) continue;
    std::string name;
    std::istringstream(line.substr(0, equals)) >> name;
    const std::size_t first = line.find_first_not_of(" \t", equals + 1);
    std::string value = first == std::string::npos ? "" : line.substr(first);
    while (!value.empty() && (value.back() == ' ' || value.back() == '\t')) value.pop_back();
    if (!header.keys.emplace(name, value).second) refuse(request, name, "stands twice");
    if (name == "ElementDataFile") return header;
  }
  refuse(request, "ElementDataFile", "is missing");
}

class MetaClaim {
 public:
  explicit MetaClaim(const Request& request) : request_(request), header_(header_of(request)) {}

  Claim claim() {
    read_grid();
    check_numbers();
    check_value_count(request_, claim_.size, claim_.components);
    check_data();
    return claim_;
  }

 private:
  /// The first of the names that the header has, "" without any.
  std::string name_of(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (header_.keys.contains(name)) return name;
    return {};
  }
  std::string value(std::initializer_list<const char*> names) const {
    const auto found = header_.keys.find(name_of(names));
    return found == header_.keys.end() ? std::string() : found->second;
  }
  std::string required(std::initializer_list<const char*> names) const {
    if (name_of(names).empty()) refuse(request_, *names.begin(), "is missing");
    return value(names);
  }
  bool flag(const char* name, bool otherwise) const {
    const std::string text = value({name});
    if (text.empty()) return otherwise;
    for (const char* yes : {"True", "true", "TRUE", "T", "1"})
      if (text == yes) return true;
    for (const char* no : {"False", "false", "FALSE", "F", "0"})
      if (text == no) return false;
    refuse(request_, name, "is neither True nor False");
  }

  void read_grid() {
    const std::string axes = required({"NDims"});
    if (axes == "2" || axes == "1")
      refuse(request_, "NDims", "is that of a flat picture, not of a volume", "Name a volume");
    if (axes != "3")
      refuse(request_, "NDims", "is \"" + axes.substr(0, 40) + "\", not that of one volume",
             "Export a single volume");
    const std::vector<int> size = sizes_in(request_, "DimSize", required({"DimSize"}), 3);
    claim_.size = {size[0], size[1], size[2]};
    const std::vector<double> spacing =
        numbers_in(request_, "ElementSpacing", required({"ElementSpacing", "ElementSize"}), 3);
    const std::string turn = name_of({"TransformMatrix", "Rotation", "Orientation"});
    Eigen::Matrix3d vectors = Eigen::Matrix3d::Identity();
    if (!turn.empty()) {
      const std::vector<double> matrix = numbers_in(request_, turn, header_.keys.at(turn), 9);
      for (int i = 0; i < 9; ++i) vectors(i % 3, i / 3) = matrix[static_cast<std::size_t>(i)];
    }
    Claim turned;
    set_axes(request_, turn.empty() ? "TransformMatrix" : turn.c_str(), vectors, turned);
    if (!((turned.spacing_mm.array() - 1.0).abs().maxCoeff() < 2e-3))
      refuse(request_, turn, "has rows that are not of length 1", "Correct the header");
    for (int axis = 0; axis < 3; ++axis) {
      if (!(spacing[static_cast<std::size_t>(axis)] > 0.0))
        refuse(request_, "ElementSpacing", "is not positive");
      vectors.col(axis) = turned.direction.col(axis) * spacing[static_cast<std::size_t>(axis)];
    }
    set_axes(request_, "ElementSpacing", vectors, claim_);
    const std::vector<double> origin =
        numbers_in(request_, "Offset", required({"Offset", "Position", "Origin"}), 3);
    claim_.origin_mm = {origin[0], origin[1], origin[2]};
    if (const std::string unit = value({"DistanceUnits"}); !unit.empty() && unit != "mm" && unit != "?")
      refuse(request_, "DistanceUnits", "is \"" + unit.substr(0, 40) + "\"",
             "Convert the volume to millimetres");
  }

  void check_numbers() {
    if (!flag("BinaryData", false))
      refuse(request_, "BinaryData", "is False: voxels as text are not read",
             "Write it with BinaryData = True");
    const std::string slope = value({"ElementToIntensityFunctionSlope"}),
                      offset = value({"ElementToIntensityFunctionOffset"});
    if (!slope.empty() && numbers_in(request_, "ElementToIntensityFunctionSlope", slope, 1).front() != 1.0)
      refuse(request_, "ElementToIntensityFunctionSlope", "is not 1", "Apply it to the voxels");
    if (!offset.empty() && numbers_in(request_, "ElementToIntensityFunctionOffset", offset, 1).front() != 0.0)
      refuse(request_, "ElementToIntensityFunctionOffset", "is not 0", "Apply it to the voxels");
    static const std::map<std::string, int> kBytes = {
        {"MET_CHAR", 1},      {"MET_UCHAR", 1},      {"MET_SHORT", 2}, {"MET_USHORT", 2},
        {"MET_INT", 4},       {"MET_UINT", 4},       {"MET_LONG", 4},  {"MET_ULONG", 4},
        {"MET_LONG_LONG", 8}, {"MET_ULONG_LONG", 8}, {"MET_FLOAT", 4}, {"MET_DOUBLE", 8}};
    const std::string type = required({"ElementType"});
    const auto known = kBytes.find(type);
    if (known == kBytes.end())
      refuse(request_, "ElementType",
             "is \"" + type.substr(0, 40) + "\", which is no number format that is known",
             "Export it as 16-bit integers");
    bytes_ = known->second;
    check_byte_order();
    if (const std::string channels = value({"ElementNumberOfChannels"}); !channels.empty())
      claim_.components = sizes_in(request_, "ElementNumberOfChannels", channels, 1).front();
  }

  /// Either name tells it; this machine's is meant where neither is there.
  void check_byte_order() const {
    const bool binary = flag("BinaryDataByteOrderMSB", false), element = flag("ElementByteOrderMSB", binary);
    if (name_of({"BinaryDataByteOrderMSB"}).empty() || binary == element) return;
    refuse(request_, "ElementByteOrderMSB", "contradicts BinaryDataByteOrderMSB");
  }

  void check_data() const {
    const std::string place = value({"ElementDataFile"});
    if (place.empty() || place.find("LIST") == 0 || place.find('%') != std::string::npos)
      refuse(request_, "ElementDataFile", "names no single file of voxels");
    const bool local = place == "LOCAL" || place == "Local" || place == "local";
    Stored stored;
    const double row = static_cast<double>(bytes_) * claim_.components * claim_.size.x();
    stored.bytes = row * claim_.size.y() * claim_.size.z();
    stored.row_bytes = row;
    stored.packed = flag("CompressedData", false);
    stored.packed_field = "CompressedData";
    stored.file = local ? request_.path : file_beside(request_, "ElementDataFile", place);
    stored.offset = local ? header_.end : 0;
    if (const std::string skip = value({"HeaderSize"}); !skip.empty()) {
      const double bytes = numbers_in(request_, "HeaderSize", skip, 1).front();
      if (bytes != 0.0 && (local || stored.packed || bytes < -1.0 || bytes > 1e9))
        refuse(request_, "HeaderSize", "is " + skip.substr(0, 40) + ", beyond what the file holds",
               "Correct it to 0");
      if (bytes < 0.0)
        stored.at_end = true;
      else
        stored.offset += static_cast<std::uintmax_t>(bytes);
    }
    check_stored(request_, stored);
    if (stored.packed) check_packed_size(stored, local);
  }

  /// The library inflates so many bytes and fills up the rest with zeros.
  void check_packed_size(const Stored& stored, bool local) const {
    const std::string said = value({"CompressedDataSize"});
    if (said.empty() && !local) return;  // all of the file
    if (said.empty()) refuse(request_, "CompressedDataSize", "is missing");
    std::error_code failure;
    const std::uintmax_t size = std::filesystem::file_size(stored.file, failure);
    const auto there = static_cast<double>(size - stored.offset);
    if (failure || numbers_in(request_, "CompressedDataSize", said, 1).front() != there)
      refuse(request_, "CompressedDataSize",
             "is " + said.substr(0, 40) + " where the file holds " +
                 std::to_string(static_cast<long>(there)) + " bytes of voxels");
  }

  const Request& request_;
  Header header_;
  Claim claim_;
  int bytes_ = 0;
};

}  // namespace

Claim claim_of_meta(const Request& request) { return MetaClaim(request).claim(); }

}  // namespace glisson::reader
