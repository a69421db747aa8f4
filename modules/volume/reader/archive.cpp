// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <iterator>
#include <limits>
#include <set>
#include <string>

#include "glisson/core/error.h"

/// @file
/// The archives of tar (POSIX ustar and pax, GNU's long names) by ourselves: what unpacks must stop before
/// the disk is full, and never leave its folder.

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlock = 512;
constexpr int kMostFiles = 100000;
constexpr int kMostFolders = 5000;  // to make and remove them takes longest
constexpr int kDeepest = 32;        // folders in folders
constexpr double kMostRatio = 100.0, kAlwaysAllowed = 256e6, kStaysFree = 1e9;
constexpr std::uint64_t kLongestName = 1U << 16;

[[noreturn]] void refuse(const Request& request, const std::string& problem, const std::string& remedy) {
  throw InputError(request.name, "", problem, remedy);
}
[[noreturn]] void damaged(const Request& request) {
  refuse(request, "cannot be unpacked: it is damaged",
         "Fetch the archive again, or unpack it yourself and name the folder");
}

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
    if (got != static_cast<int>(size)) damaged(request_);
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

/// Below the folder whatever it is called; empty: nothing is left of it.
fs::path kept_path(const std::string& name) {
  fs::path kept;
  for (const fs::path& part : fs::path(name).relative_path()) {
    if (part == "..") return {};
    if (part != "." && !part.empty()) kept /= part;
  }
  return kept;
}

class Unpacker {
 public:
  Unpacker(const Request& request, fs::path folder)
      : request_(request), folder_(std::move(folder)), bytes_(request) {
    struct statvfs disk {};
    if (::statvfs(folder_.c_str(), &disk) == 0)
      free_ = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize) - kStaysFree;
    std::error_code failure;
    packed_size_ = std::max(1.0, static_cast<double>(fs::file_size(request.path, failure)));
  }

  void run() {
    std::array<char, kBlock> block{};
    Entry pending;
    bool has_name = false, has_size = false;
    while (bytes_.read(block.data(), kBlock)) {
      spend(kBlock, -1);
      if (std::all_of(block.begin(), block.end(), [](char c) { return c == '\0'; })) {
        ended_ = true;
        continue;  // the end's mark, and padding
      }
      Entry entry;
      if (ended_ || !parse(block, entry)) damaged(request_);
      if (entry.kind == 'L' || entry.kind == 'x') {
        if (entry.size > kLongestName) damaged(request_);
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
    if (!ended_) damaged(request_);
  }

 private:
  std::string small_content(std::uint64_t size) {
    std::string content(static_cast<std::size_t>(size + kBlock - 1) / kBlock * kBlock, '\0');
    spend(static_cast<double>(content.size()), -1);
    if (!content.empty() && !bytes_.read(content.data(), content.size())) damaged(request_);
    content.resize(static_cast<std::size_t>(size));
    return content;
  }

  void take(const Entry& entry) {
    const fs::path name = kept_path(entry.name);
    int file = -1;
    if ((entry.kind == '0' || entry.kind == '7') && !name.empty()) file = make(name);
    std::array<char, 128 * kBlock> buffer{};
    for (std::uint64_t left = entry.size; left > 0;) {
      const auto part = std::min<std::uint64_t>((left + kBlock - 1) / kBlock * kBlock, buffer.size());
      spend(static_cast<double>(part), file);
      if (!bytes_.read(buffer.data(), static_cast<std::size_t>(part))) damaged(request_);
      const auto wanted = static_cast<std::size_t>(std::min(left, part));
      if (file >= 0 && ::write(file, buffer.data(), wanted) != static_cast<ssize_t>(wanted)) {
        ::close(file);
        throw FileError(folder_.string() + ": could not be written. Free space for temporary files.");
      }
      left -= wanted;
    }
    if (file >= 0) ::close(file);
  }

  /// The folders above a file, each once.
  void make_folders(const fs::path& name) {
    if (std::distance(name.begin(), name.end()) > kDeepest + 1)
      refuse(request_, "holds folders in folders more than 32 deep, which no series has",
             "Unpack it yourself and name the folder of the series");
    fs::path above;
    for (const fs::path& part : name.parent_path()) {
      above /= part;
      if (!folders_.insert(above.string()).second) continue;
      if (folders_.size() > kMostFolders)
        refuse(request_, "holds more than 5000 folders, which no series has",
               "Unpack it yourself and name the folder of the series");
      std::error_code failure;
      fs::create_directory(folder_ / above, failure);
    }
  }

  int make(const fs::path& name) {
    if (++files_ > kMostFiles)
      refuse(request_, "holds more than 100000 files, which no series has",
             "Unpack it yourself and name the folder of the series");
    make_folders(name);
    const int file =
        ::open((folder_ / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (file < 0)
      throw FileError((folder_ / name).string() + ": could not be made (" + std::strerror(errno) +
                      "). Free space for temporary files.");
    return file;
  }

  /// What is passed over counts, too: it takes its time.
  void spend(double bytes, int file) {
    total_ += bytes;
    const bool bomb = total_ > kAlwaysAllowed + kMostRatio * bytes_.packed(), full = total_ > free_;
    if (!bomb && !full) return;
    if (file >= 0) ::close(file);
    if (bomb)
      refuse(request_, "unpacks to more than a hundred times its size, which no images do",
             "Ask where it comes from; unpack it yourself and name the folder if it is good");
    refuse(request_, "needs more space for temporary files than is free in " + folder_.parent_path().string(),
           "Free some space, set TMPDIR to a larger disk, or unpack it yourself and name the folder");
  }

  const Request& request_;
  fs::path folder_;
  Bytes bytes_;
  double free_ = std::numeric_limits<double>::infinity(), packed_size_ = 1.0, total_ = 0.0;
  int files_ = 0;
  std::set<std::string> folders_;
  bool ended_ = false;
};

}  // namespace

void unpack_archive(const Request& request, const fs::path& folder) { Unpacker(request, folder).run(); }

}  // namespace glisson::reader
