// SPDX-License-Identifier: GPL-3.0-or-later
#include "claim.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "glisson/core/error.h"

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExport = "The header is damaged: export the volume again";
constexpr double kMostRatio = 100.0, kAlwaysAllowed = 256e6;  // as of archives
constexpr double kMostPacking = 1100.0;                       // deflate packs to 1/1032 at the best

/// Inflates a file from `offset` on, member after member, and counts. Negative: it cannot be inflated.
class Inflation {
 public:
  Inflation(const fs::path& file, std::uintmax_t offset) : stream_(file, std::ios::binary) {
    stream_.seekg(static_cast<std::streamoff>(offset));
    ready_ = inflateInit2(&state_, 15 + 32) == Z_OK;  // zlib or gzip, as it says itself
  }
  ~Inflation() {
    if (ready_) inflateEnd(&state_);
  }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  double count(double most) {
    double total = 0.0;
    bool ended = false;
    while (ready_ && total <= most && refill()) {
      if (ended) {  // another member, or what is no part of the data
        if (inflateReset(&state_) != Z_OK) return -1.0;
        ended = false;
      }
      state_.next_out = out_.data();
      state_.avail_out = static_cast<uInt>(out_.size());
      const int result = inflate(&state_, Z_NO_FLUSH);
      total += static_cast<double>(out_.size() - state_.avail_out);
      if (result == Z_STREAM_END) ended = true;
      if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
        return total > 0.0 && passed_ ? total : -1.0;
      passed_ = passed_ || ended;
    }
    return ended || total > most ? total : -1.0;
  }

 private:
  bool refill() {
    if (state_.avail_in > 0) return true;
    stream_.read(reinterpret_cast<char*>(in_.data()), static_cast<std::streamsize>(in_.size()));
    state_.next_in = in_.data();
    state_.avail_in = static_cast<uInt>(stream_.gcount());
    return state_.avail_in > 0;
  }

  std::ifstream stream_;
  z_stream state_{};
  bool ready_ = false, passed_ = false;
  std::vector<unsigned char> in_ = std::vector<unsigned char>(1U << 16);
  std::vector<unsigned char> out_ = std::vector<unsigned char>(1U << 18);
};

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Some writers fill up to a whole word, or end the line: what lies behind the voxels is then empty.
/// Values there say that bytes were put in before.
bool is_padding(const fs::path& file, std::uintmax_t from) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(from));
  const auto is_empty = [](char c) { return c == 0 || c == '\n' || c == '\r'; };
  return std::all_of(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>(), is_empty);
}

}  // namespace

std::vector<double> numbers_in(const Request& request, const std::string& field, const std::string& text,
                               std::size_t count) {
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    double value = 0.0;
    const char* begin = word.c_str() + (word.front() == '+' ? 1 : 0);
    const auto [end, failure] = std::from_chars(begin, word.c_str() + word.size(), value);
    if (failure != std::errc() || end != word.c_str() + word.size() || !std::isfinite(value))
      throw InputError(request.name, field, "holds \"" + word.substr(0, 40) + "\", which is no number",
                       kExport);
    numbers.push_back(value);
  }
  if (numbers.size() != count)
    throw InputError(request.name, field,
                     "holds " + std::to_string(numbers.size()) + " numbers where " + std::to_string(count) +
                         " are expected",
                     kExport);
  return numbers;
}

std::vector<int> sizes_in(const Request& request, const std::string& field, const std::string& text,
                          std::size_t count) {
  std::vector<int> sizes;
  for (const double value : numbers_in(request, field, text, count)) {
    if (!(value >= 1.0 && value <= 100000.0) || value != std::floor(value))
      throw InputError(request.name, field, "holds " + shown(value) + ", which is no number of voxels",
                       kExport);
    sizes.push_back(static_cast<int>(value));
  }
  return sizes;
}

void set_axes(const Request& request, const char* field, const Eigen::Matrix3d& vectors_mm, Claim& claim) {
  for (int axis = 0; axis < 3; ++axis) {
    // Not norm(): it would overflow, or be zero, where the numbers are absurd but finite.
    const double length = vectors_mm.col(axis).stableNorm();
    if (!(length > 1e-9 && length < 1e9))
      throw InputError(request.name, field,
                       "has an axis of " + shown(length) + " mm from voxel to voxel, which is no patient's",
                       "Correct the header, or export the volume again");
    claim.spacing_mm[axis] = length;
    claim.direction.col(axis) = vectors_mm.col(axis) / length;
  }
  const Eigen::Matrix3d product = claim.direction.transpose() * claim.direction;
  if (!((product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 2e-3))
    throw InputError(request.name, field, "has axes that are not at right angles (a sheared volume)",
                     "Resample the volume to a rectangular grid");
}

void check_claim(const Request& request, const Claim& claim, const VolumeGrid& grid) {
  if (claim.size != grid.size)
    throw InputError(request.name, "size", "is read differently by two readers", kExport);
  const Eigen::Vector3d far = (grid.size - Eigen::Vector3i::Ones()).cast<double>();
  const double allowed = 0.02 * grid.spacing_mm.minCoeff() +
                         claim.precision * far.cwiseProduct(grid.spacing_mm).norm() +
                         1e-6 * claim.origin_mm.norm();
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index =
        far.cwiseProduct(Eigen::Vector3d(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1));
    const Eigen::Vector3d said = claim.origin_mm + claim.direction * index.cwiseProduct(claim.spacing_mm);
    const double apart = (said - 1e3 * grid.p_in_ct(index).xyz).norm();
    if (!(apart <= allowed))
      throw InputError(request.name, "spacing, origin, direction",
                       "are read differently by two readers, by up to " + shown(apart) + " mm", kExport);
  }
}

void check_stored(const Request& request, const Stored& stored) {
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(stored.file, failure);
  if (failure || size < stored.offset)
    throw InputError(request.name, "voxels", "end early: the file is damaged", "Export it again");
  const auto there = static_cast<double>(size - stored.offset);
  double bytes = there;
  if (stored.packed && stored.bytes > kAlwaysAllowed + kMostRatio * there)
    throw InputError(request.name, stored.packed_field,
                     "unpacks to more than a hundred times its size, which no images do",
                     "Ask where it comes from; unpack it yourself and name the file if it is good");
  if (stored.packed) {
    bytes = stored.bytes > kMostPacking * there
                ? 0.0
                : Inflation(stored.file, stored.offset).count(stored.bytes + 1e6);
    if (bytes < 0.0)
      throw InputError(request.name, stored.packed_field,
                       "says that the voxels are compressed, but they are not, or are damaged",
                       "Export it again");
  }
  if (bytes < stored.bytes)
    throw InputError(request.name, "voxels", "end early: the file is damaged", "Export it again");
  if (stored.at_end) return;  // what lies before them is passed over
  if (bytes >= stored.bytes + stored.row_bytes ||
      (!stored.packed && !is_padding(stored.file, stored.offset + static_cast<std::uintmax_t>(stored.bytes))))
    throw InputError(request.name, "size",
                     "says fewer voxels than the file holds (" + shown(stored.bytes) + " of " + shown(bytes) +
                         " bytes or more)",
                     kExport);
}

fs::path file_beside(const Request& request, const char* field, const std::string& named) {
  const fs::path name = named;
  if (name.empty() || name.has_parent_path() || name == "." || name == "..")
    throw InputError(request.name, field,
                     "names \"" + named.substr(0, 80) + "\", which lies in another folder",
                     "Put it beside the header and name it there without a folder");
  const fs::path file = request.path.parent_path() / name;
  std::error_code failure;
  if (!fs::is_regular_file(file, failure))
    throw InputError(request.name, field, "names " + named.substr(0, 80) + ", which is missing",
                     "Put it beside the header");
  return file;
}

}  // namespace glisson::reader
