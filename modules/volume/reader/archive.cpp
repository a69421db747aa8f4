// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "unpacked_folder.h"

/// @file
/// The archives of tar (POSIX ustar and pax, GNU's long names) by ourselves: what unpacks must stop before
/// the disk is full, and never leave its folder.

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlock = 512;
constexpr std::uint64_t kLongestName = 1U << 16;

/// The archive's bytes; zlib reads plain files as they are.
class Bytes {
 public:
  explicit Bytes(const Request& request) : request_(request), file_(gzopen(request.path.c_str(), "rb")) {
    if (file_ == nullptr) throw FileError(request.name + ": cannot be opened. Check the path.");
    gzbuffer(file_, 1U << 17);
  }
  ~Bytes() { gzclose(file_); }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  /// False at the archive's end. @throws InputError damaged, or ending in the middle.
  bool read(char* to, std::size_t size) {
    const int got = gzread(file_, to, static_cast<unsigned>(size));
    if (got == 0 && gzeof(file_) != 0) return false;
    if (got != static_cast<int>(size)) refuse_damaged(request_);
    return true;
  }
  /// How much of the file was read, of what it is packed into.
  double packed() const { return static_cast<double>(gzoffset(file_)); }

 private:
  const Request& request_;
  gzFile file_;
};

/// What a tar header says of the next file.
struct Entry {
  std::string name;
  std::uint64_t size = 0;
  char kind = '0';
};

/// A number in octal digits, or GNU's binary one. @return false: it is none.
bool number(const char* field, std::size_t length, std::uint64_t& value) {
  value = 0;
  if (static_cast<unsigned char>(field[0]) == 0x80) {
    for (std::size_t i = 1; i < length; ++i) {
      if (value >> 56 != 0) return false;
      value = value << 8 | static_cast<unsigned char>(field[i]);
    }
    return true;
  }
  bool any = false;
  for (std::size_t i = 0; i < length && field[i] != '\0'; ++i) {
    if (field[i] == ' ') {
      if (any) break;
      continue;
    }
    if (field[i] < '0' || field[i] > '7' || value >> 60 != 0) return false;
    value = value << 3 | static_cast<std::uint64_t>(field[i] - '0');
    any = true;
  }
  return true;
}

std::string text(const char* field, std::size_t length) { return std::string(field, strnlen(field, length)); }

bool parse(const std::array<char, kBlock>& block, Entry& entry) {
  std::uint64_t said = 0, sum = 0;
  if (!number(&block[148], 8, said)) return false;
  for (std::size_t i = 0; i < kBlock; ++i)
    sum += i >= 148 && i < 156 ? ' ' : static_cast<unsigned char>(block[i]);
  if (sum != said || !number(&block[124], 12, entry.size)) return false;
  entry.kind = block[156] == '\0' ? '0' : block[156];
  entry.name = text(block.data(), 100);
  if (std::memcmp(&block[257], "ustar", 5) == 0 && block[262] == '\0')
    if (const std::string prefix = text(&block[345], 155); !prefix.empty())
      entry.name = prefix + "/" + entry.name;
  return true;
}

/// The path and size in a pax header ("LENGTH key=value\n" after another).
void take_pax(const std::string& records, Entry& next, bool& has_size) {
  for (std::size_t at = 0; at < records.size();) {
    std::size_t length = 0;
    const auto [end, failure] = std::from_chars(records.data() + at, records.data() + records.size(), length);
    const auto digits = static_cast<std::size_t>(end - records.data()) - at;
    if (failure != std::errc() || length <= digits + 2 || length > records.size() - at) return;
    const std::string record = records.substr(at + digits + 1, length - digits - 2);
    at += length;
    if (record.starts_with("path=")) next.name = record.substr(5);
    if (record.starts_with("size="))
      has_size =
          std::from_chars(record.data() + 5, record.data() + record.size(), next.size).ec == std::errc();
  }
}

class Unpacker {
 public:
  Unpacker(const Request& request, const fs::path& folder)
      : request_(request), folder_(request, folder), bytes_(request) {
    std::error_code failure;
    packed_size_ = std::max(1.0, static_cast<double>(fs::file_size(request.path, failure)));
  }

  void run() {
    std::array<char, kBlock> block{};
    Entry pending;
    bool has_name = false, has_size = false;
    while (bytes_.read(block.data(), kBlock)) {
      spend(kBlock);
      if (std::all_of(block.begin(), block.end(), [](char c) { return c == '\0'; })) {
        ended_ = true;
        continue;  // the end's mark, and padding
      }
      Entry entry;
      if (ended_ || !parse(block, entry)) refuse_damaged(request_);
      if (entry.kind == 'L' || entry.kind == 'x') {
        if (entry.size > kLongestName) refuse_damaged(request_);
        std::string content = small_content(entry.size);
        if (entry.kind == 'L')
          pending.name = content.c_str();  // NOLINT: up to its end
        else
          take_pax(content, pending, has_size);
        has_name = !pending.name.empty();
        continue;
      }
      if (has_name) entry.name = pending.name;
      if (has_size) entry.size = pending.size;
      pending = {};
      has_name = has_size = false;
      take(entry);
      request_.progress(std::min(1.0, bytes_.packed() / packed_size_));
    }
    if (!ended_) refuse_damaged(request_);
  }

 private:
  std::string small_content(std::uint64_t size) {
    std::string content(static_cast<std::size_t>(size + kBlock - 1) / kBlock * kBlock, '\0');
    spend(static_cast<double>(content.size()));
    if (!content.empty() && !bytes_.read(content.data(), content.size())) refuse_damaged(request_);
    content.resize(static_cast<std::size_t>(size));
    return content;
  }

  void take(const Entry& entry) {
    // Archives older than ustar tell a folder by the slash behind its name.
    const bool is_file = (entry.kind == '0' || entry.kind == '7') && !entry.name.ends_with('/');
    const OpenFile file(is_file ? folder_.make(entry.name) : -1);
    std::array<char, 128 * kBlock> buffer{};
    for (std::uint64_t left = entry.size; left > 0;) {
      const auto part = std::min<std::uint64_t>((left + kBlock - 1) / kBlock * kBlock, buffer.size());
      spend(static_cast<double>(part));
      if (!bytes_.read(buffer.data(), static_cast<std::size_t>(part))) refuse_damaged(request_);
      const auto wanted = static_cast<std::size_t>(std::min(left, part));
      folder_.write(file.number(), buffer.data(), wanted);
      left -= wanted;
    }
  }

  void spend(double bytes) { folder_.spend(bytes, bytes_.packed()); }

  const Request& request_;
  UnpackedFolder folder_;
  Bytes bytes_;
  double packed_size_ = 1.0;
  bool ended_ = false;
};

}  // namespace

void unpack_archive(const Request& request, const fs::path& folder) {
  if (lower_extension(request.path) == ".zip")
    unpack_zip(request, folder);
  else
    Unpacker(request, folder).run();
}

}  // namespace glisson::reader
