// SPDX-License-Identifier: GPL-3.0-or-later
#include "zip_directory.h"

#include <sys/stat.h>

#include <algorithm>

#include "glisson/core/error.h"
#include "unpacked_folder.h"

namespace glisson::reader {
namespace {

constexpr std::uint64_t kWide = 0xFFFFFFFFULL, kWideCount = 0xFFFF;
constexpr std::uint64_t kEnd = 22, kLocator = 20, kWideEnd = 56, kHeader = 46;
constexpr std::uint64_t kLongestComment = 0xFFFF, kLongestDirectory = 100000000;

/// Where the directory lies, and how many files it names.
struct Directory {
  std::uint64_t place = 0, size = 0, count = 0;
};

/// The mark of the end lies before a comment that reaches just to the end of the file.
std::uint64_t place_of_end(const Request& request, ZipBytes& bytes) {
  if (bytes.size() < kEnd) refuse_damaged(request);
  const std::uint64_t length = std::min(bytes.size(), kEnd + kLongestComment);
  const std::uint64_t first = bytes.size() - length;
  const std::string tail = bytes.at(first, length);
  for (std::size_t at = tail.size() - kEnd + 1; at-- > 0;)
    if (tail.compare(at, 4, "PK\5\6") == 0 && zip_number(tail, at + 20, 2) == tail.size() - at - kEnd)
      return first + at;
  refuse_damaged(request);
}

Directory find_directory(const Request& request, ZipBytes& bytes) {
  std::uint64_t end = place_of_end(request, bytes);
  const std::string text = bytes.at(end, kEnd);
  Directory found{zip_number(text, 16, 4), zip_number(text, 12, 4), zip_number(text, 10, 2)};
  const bool is_wide = found.place == kWide || found.size == kWide || found.count == kWideCount;
  if (is_wide && end >= kLocator && bytes.at(end - kLocator, 4) == "PK\6\7") {
    end = zip_number(bytes.at(end - kLocator, kLocator), 8, 8);
    const std::string wide = bytes.at(end, kWideEnd);
    if (!wide.starts_with("PK\6\6")) refuse_damaged(request);
    found = {zip_number(wide, 48, 8), zip_number(wide, 40, 8), zip_number(wide, 32, 8)};
  } else if (zip_number(text, 4, 2) != 0 || zip_number(text, 6, 2) != 0) {
    refuse(request, "", "is one of several parts of an archive", "Unpack them yourself and name the folder");
  }
  if (found.size > kLongestDirectory || found.size > end || found.place > end - found.size)
    refuse_damaged(request);
  return found;
}

/// Sizes and place that do not fit into 32 bits, in their order.
void take_wide(const std::string& extra, ZipEntry& entry) {
  for (std::size_t at = 0; at + 4 <= extra.size();) {
    const std::uint64_t id = zip_number(extra, at, 2), length = zip_number(extra, at + 2, 2);
    at += 4;
    if (length > extra.size() - at) return;
    std::size_t next = at;
    if (id == 1)
      for (std::uint64_t* value : {&entry.size, &entry.packed, &entry.header})
        if (*value == kWide && next + 8 <= at + length) {
          *value = zip_number(extra, next, 8);
          next += 8;
        }
    at += static_cast<std::size_t>(length);
  }
}

ZipEntry entry_of(const std::string& header, const std::string& name, const std::string& extra) {
  ZipEntry entry;
  entry.name = name;
  // Some programs of Windows write their own separators.
  std::replace(entry.name.begin(), entry.name.end(), '\\', '/');
  entry.flags = static_cast<unsigned>(zip_number(header, 8, 2));
  entry.method = static_cast<unsigned>(zip_number(header, 10, 2));
  entry.crc = static_cast<std::uint32_t>(zip_number(header, 16, 4));
  entry.packed = zip_number(header, 20, 4);
  entry.size = zip_number(header, 24, 4);
  entry.header = zip_number(header, 42, 4);
  take_wide(extra, entry);
  constexpr std::uint64_t kUnix = 3;
  const std::uint64_t mode = zip_number(header, 40, 2) & S_IFMT;
  const bool is_odd = zip_number(header, 5, 1) == kUnix && mode != 0 && mode != S_IFREG;
  entry.is_file = !entry.name.empty() && entry.name.back() != '/' && !is_odd &&
                  entry.name.find('\0') == std::string::npos;
  return entry;
}

}  // namespace

ZipBytes::ZipBytes(const Request& request)
    : request_(request), stream_(request.path, std::ios::binary | std::ios::ate) {
  if (!stream_) throw FileError(request.name + ": cannot be opened. Check the path.");
  size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(0, stream_.tellg()));
}

std::string ZipBytes::at(std::uint64_t place, std::uint64_t count) {
  if (place > size_ || count > size_ - place) refuse_damaged(request_);
  std::string bytes(static_cast<std::size_t>(count), '\0');
  stream_.seekg(static_cast<std::streamoff>(place));
  stream_.read(bytes.data(), static_cast<std::streamsize>(count));
  if (!stream_) refuse_damaged(request_);
  return bytes;
}

std::uint64_t zip_number(const std::string& bytes, std::size_t at, int size) {
  std::uint64_t value = 0;
  for (int n = size - 1; n >= 0; --n)
    value = value << 8U | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(n)]);
  return value;
}

std::vector<ZipEntry> zip_directory(const Request& request, ZipBytes& bytes) {
  const Directory directory = find_directory(request, bytes);
  const std::string text = bytes.at(directory.place, directory.size);
  std::vector<ZipEntry> entries;
  double packed = 0.0;
  std::size_t at = 0;
  for (std::uint64_t n = 0; n < directory.count; ++n) {
    if (text.size() - at < kHeader || text.compare(at, 4, "PK\1\2") != 0) refuse_damaged(request);
    const std::string header = text.substr(at, kHeader);
    const auto name = static_cast<std::size_t>(zip_number(header, 28, 2)),
               extra = static_cast<std::size_t>(zip_number(header, 30, 2)),
               comment = static_cast<std::size_t>(zip_number(header, 32, 2));
    if (text.size() - at - kHeader < name + extra + comment) refuse_damaged(request);
    at += kHeader;
    entries.push_back(entry_of(header, text.substr(at, name), text.substr(at + name, extra)));
    at += name + extra + comment;
    // Files that lie in each other make a small archive a large one.
    packed += static_cast<double>(entries.back().packed);
    if (packed > static_cast<double>(bytes.size())) refuse_damaged(request);
  }
  return entries;
}

}  // namespace glisson::reader
