// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "claim.h"
#include "glisson/core/files.h"
#include "header_lines.h"
#include "text_values.h"

/// @file
/// A NRRD's header (http://teem.sourceforge.net/nrrd/format.html), as far as a patient's volume needs it.

namespace glisson::reader {
namespace {

constexpr std::size_t kLongestHeader = 1U << 24;  // segmentations carry long tags

struct Header {
  std::map<std::string, std::string> fields;  ///< names in lower case
  std::uintmax_t end = 0;                     ///< where attached data begin
};

constexpr HeaderRefusal refuse{"Correct the header, or export the volume again"};

Header header_of(const Request& request) {
  HeaderLines lines(request, kLongestHeader);
  Header header;
  std::string line;
  if (!lines.next(line) || line.rfind("NRRD000", 0) != 0)
    refuse(request, "", "is not a NRRD file", "Export it again");
  while (lines.next(line) && !line.empty()) {
    const std::size_t colon = line.find(": ");
    const std::size_t pair = line.find(":=");
    if (line.front() == '#' || colon == std::string::npos || pair < colon) continue;
    const std::string name = lower_case(line.substr(0, colon));
    if (!header.fields.emplace(name, line.substr(colon + 2)).second) refuse(request, name, "stands twice");
  }
  header.end = lines.end();  // a detached one may end with the file
  return header;
}

class NrrdClaim {
 public:
  explicit NrrdClaim(const Request& request) : request_(request), header_(header_of(request)) {}

  Claim claim() {
    check_encoding();
    const auto axes =
        static_cast<std::size_t>(sizes_in(request_, "dimension", required("dimension"), 1).front());
    if (axes < 3)
      refuse(request_, "dimension", "is that of a flat picture, not of a volume", "Name a volume");
    if (axes > 16) refuse(request_, "dimension", "is more than 16");
    const std::vector<int> sizes = sizes_in(request_, "sizes", required("sizes"), axes);
    read_space(axes, sizes);
    check_value_count(request_, claim_.size, claim_.components);
    check_data();
    return claim_;
  }

 private:
  std::string field(const std::string& name) const {
    const auto found = header_.fields.find(name);
    return found == header_.fields.end() ? std::string() : found->second;
  }
  std::string required(const std::string& name) const {
    if (!header_.fields.contains(name)) refuse(request_, name, "is missing");
    return field(name);
  }

  void check_encoding() {
    const std::string encoding = lower_case(required("encoding"));
    packed_ = encoding == "gzip" || encoding == "gz";
    text_ = encoding == "ascii" || encoding == "text" || encoding == "txt";
    if (!packed_ && !text_ && encoding != "raw")
      refuse(request_, "encoding", "is \"" + encoding.substr(0, 40) + "\", which is not read",
             "Write it with the encoding gzip or raw");
    static const std::map<std::string, int> kBytes = {{"signed char", 1},
                                                      {"int8", 1},
                                                      {"int8_t", 1},
                                                      {"uchar", 1},
                                                      {"unsigned char", 1},
                                                      {"uint8", 1},
                                                      {"uint8_t", 1},
                                                      {"short", 2},
                                                      {"short int", 2},
                                                      {"signed short", 2},
                                                      {"signed short int", 2},
                                                      {"int16", 2},
                                                      {"int16_t", 2},
                                                      {"ushort", 2},
                                                      {"unsigned short", 2},
                                                      {"unsigned short int", 2},
                                                      {"uint16", 2},
                                                      {"uint16_t", 2},
                                                      {"int", 4},
                                                      {"signed int", 4},
                                                      {"int32", 4},
                                                      {"int32_t", 4},
                                                      {"uint", 4},
                                                      {"unsigned int", 4},
                                                      {"uint32", 4},
                                                      {"uint32_t", 4},
                                                      {"longlong", 8},
                                                      {"long long", 8},
                                                      {"long long int", 8},
                                                      {"signed long long", 8},
                                                      {"signed long long int", 8},
                                                      {"int64", 8},
                                                      {"int64_t", 8},
                                                      {"ulonglong", 8},
                                                      {"unsigned long long", 8},
                                                      {"unsigned long long int", 8},
                                                      {"uint64", 8},
                                                      {"uint64_t", 8},
                                                      {"float", 4},
                                                      {"double", 8}};
    const std::string type = lower_case(required("type"));
    const auto known = kBytes.find(type);
    if (known == kBytes.end())
      refuse(request_, "type", "is \"" + type.substr(0, 40) + "\", which is no number format that is known",
             "Export it as 16-bit integers");
    bytes_ = known->second;
    type_ = {bytes_, type.front() != 'u', type != "float" && type != "double"};
    if (bytes_ > 1 && !text_ && !header_.fields.contains("endian")) refuse(request_, "endian", "is missing");
  }

  void read_space(std::size_t axes, const std::vector<int>& sizes) {
    const Eigen::Vector3d to_lps = signs();
    for (const std::string& unit : quoted(field("space units")))
      if (unit != "mm" && unit != "millimeter" && !unit.empty())
        refuse(request_, "space units", "are \"" + unit.substr(0, 40) + "\"",
               "Convert the volume to millimetres");
    Eigen::Matrix3d vectors;
    int spatial = 0;
    double components = 1.0;
    std::istringstream words(required("space directions"));
    std::string word;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      if (!(words >> word)) refuse(request_, "space directions", "are fewer than there are axes");
      while (word.front() == '(' && word.back() != ')') {  // blanks within the brackets
        std::string rest;
        if (!(words >> rest)) refuse(request_, "space directions", "hold a bracket that is not closed");
        word += rest;
      }
      if (word == "none") {
        components *= sizes[axis];
      } else {
        if (spatial == 3) refuse(request_, "space directions", "are of more than three axes in space");
        claim_.size[spatial] = sizes[axis];
        vectors.col(spatial++) = to_lps.cwiseProduct(vector("space directions", word));
      }
    }
    if (spatial != 3) refuse(request_, "space directions", "are of fewer than three axes in space");
    claim_.components = static_cast<int>(std::min(components, 1e9));
    set_axes(request_, "space directions", vectors, claim_);
    claim_.origin_mm = to_lps.cwiseProduct(vector("space origin", required("space origin")));
  }

  Eigen::Vector3d signs() const {
    const std::string space = lower_case(field("space"));
    if (space == "left-posterior-superior" || space == "lps") return {1, 1, 1};
    if (space == "right-anterior-superior" || space == "ras") return {-1, -1, 1};
    if (space == "left-anterior-superior" || space == "las") return {1, -1, 1};
    refuse(request_, "space",
           space.empty() ? std::string("is missing: the file does not say which way the patient lies")
                         : "is \"" + space.substr(0, 60) + "\", which is no patient's",
           "Write it as left-posterior-superior with space directions in mm");
  }

  Eigen::Vector3d vector(const std::string& name, std::string text) const {
    if (text.size() < 2 || text.front() != '(' || text.back() != ')')
      refuse(request_, name, "holds \"" + text.substr(0, 40) + "\", which is no vector");
    text = text.substr(1, text.size() - 2);
    std::replace(text.begin(), text.end(), ',', ' ');
    const std::vector<double> numbers = numbers_in(request_, name, text, 3);
    return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  }

  static std::vector<std::string> quoted(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = text.find('"'); begin != std::string::npos; begin = text.find('"', begin)) {
      const std::size_t end = text.find('"', begin + 1);
      if (end == std::string::npos) break;
      parts.push_back(text.substr(begin + 1, end - begin - 1));
      begin = end + 1;
    }
    return parts;
  }

  void check_data() const {
    if (text_) return check_text();
    Stored stored;
    stored.packed = packed_;
    const double row = static_cast<double>(bytes_) * claim_.components * claim_.size.x();
    stored.bytes = row * claim_.size.y() * claim_.size.z();
    stored.row_bytes = row;
    const std::string place = header_.fields.contains("data file") ? field("data file") : field("datafile");
    stored.file = place.empty() ? request_.path : file_beside(request_, "data file", place);
    stored.offset = place.empty() ? header_.end : 0;
    if (!skipped("line skip").empty())
      refuse(request_, "line skip", "is not read here", "Write the data without lines before them");
    if (const std::string skip = skipped("byte skip"); !skip.empty()) {
      const double bytes = numbers_in(request_, "byte skip", skip, 1).front();
      if (packed_ || bytes < -1.0)
        refuse(request_, "byte skip", "is not read here", "Write the data without bytes before them");
      if (bytes < 0.0)
        stored.at_end = true;
      else
        stored.offset += static_cast<std::uintmax_t>(std::min(bytes, 1e18));
    }
    check_stored(request_, stored);
  }

  void check_text() const {
    if (!skipped("line skip").empty() || !skipped("byte skip").empty())
      refuse(request_, "line skip, byte skip", "is not read here",
             "Write the data without bytes before them");
    const std::string place = header_.fields.contains("data file") ? field("data file") : field("datafile");
    const std::string content =
        read_file(place.empty() ? request_.path : file_beside(request_, "data file", place));
    const std::size_t begin = place.empty() ? std::min<std::size_t>(header_.end, content.size()) : 0;
    check_text_values(request_, "voxels", std::string_view(content).substr(begin),
                      claim_.size.cast<double>().prod() * claim_.components, type_);
  }

  std::string skipped(const char* name) const {
    std::string skip = field(name);
    if (skip.empty()) {
      std::string other = name;
      other.erase(other.find(' '), 1);
      skip = field(other);
    }
    return skip == "0" ? std::string() : skip;
  }

  const Request& request_;
  Header header_;
  Claim claim_;
  int bytes_ = 0;
  NumberType type_;
  bool packed_ = false, text_ = false;
};

}  // namespace

Claim claim_of_nrrd(const Request& request) { return NrrdClaim(request).claim(); }

}  // namespace glisson::reader
