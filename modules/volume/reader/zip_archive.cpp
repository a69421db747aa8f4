// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <algorithm>
#include <array>

#include "archive.h"
#include "unpacked_folder.h"
#include "zip_directory.h"

/// @file
/// The archives of zip by ourselves, as those of tar: what unpacks must stop before the disk is full, and
/// never leave its folder. The packing itself is zlib's.

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPart = 1U << 16U;
constexpr unsigned kStored = 0, kDeflated = 8;

/// One file's bytes on their way out: counted, summed, written.
class Outlet {
 public:
  Outlet(const Request& request, const ZipEntry& entry, UnpackedFolder& folder, double archive)
      : request_(request),
        entry_(entry),
        folder_(folder),
        archive_(archive),
        file_(folder.make(entry.name)) {}

  void take(const char* bytes, std::size_t count) {
    size_ += count;
    if (size_ > entry_.size) refuse_damaged(request_);
    folder_.spend(static_cast<double>(count), archive_);
    folder_.write(file_.number(), bytes, count);
    sum_ = crc32(sum_, reinterpret_cast<const Bytef*>(bytes), static_cast<unsigned>(count));
  }
  void end() const {
    if (size_ != entry_.size || sum_ != entry_.crc) refuse_damaged(request_);
  }

 private:
  const Request& request_;
  const ZipEntry& entry_;
  UnpackedFolder& folder_;
  double archive_;
  OpenFile file_;
  std::uint64_t size_ = 0;
  unsigned long sum_ = crc32(0, nullptr, 0);
};

class Inflater {
 public:
  Inflater() { good_ = inflateInit2(&stream_, -MAX_WBITS) == Z_OK; }
  ~Inflater() {
    if (good_) inflateEnd(&stream_);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  bool ended() const { return ended_; }
  /// False: the bytes are none of this packing.
  bool take(std::string& packed, Outlet& outlet) {
    std::array<char, kPart> buffer{};
    stream_.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream_.avail_in = static_cast<unsigned>(packed.size());
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream_.avail_out = static_cast<unsigned>(buffer.size());
      const int state = good_ && !ended_ ? inflate(&stream_, Z_NO_FLUSH) : Z_DATA_ERROR;
      if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR) return false;
      outlet.take(buffer.data(), buffer.size() - stream_.avail_out);
      ended_ = state == Z_STREAM_END;
    } while (!ended_ && stream_.avail_out == 0);
    return stream_.avail_in == 0;
  }

 private:
  z_stream stream_{};
  bool good_ = false, ended_ = false;
};

/// Where the bytes of a file begin: behind its local header, of lengths of its own.
std::uint64_t place_of(const Request& request, ZipBytes& bytes, const ZipEntry& entry) {
  constexpr std::uint64_t kLocal = 30;
  const std::string local = bytes.at(entry.header, kLocal);
  if (!local.starts_with("PK\3\4")) refuse_damaged(request);
  return entry.header + kLocal + zip_number(local, 26, 2) + zip_number(local, 28, 2);
}

void unpack_entry(const Request& request, ZipBytes& bytes, const ZipEntry& entry, UnpackedFolder& folder) {
  Outlet outlet(request, entry, folder, static_cast<double>(bytes.size()));
  Inflater inflater;
  std::uint64_t place = place_of(request, bytes, entry);
  for (std::uint64_t left = entry.packed; left > 0;) {
    const std::uint64_t part = std::min(left, kPart);
    std::string packed = bytes.at(place, part);
    if (entry.method == kStored)
      outlet.take(packed.data(), packed.size());
    else if (!inflater.take(packed, outlet))
      refuse_damaged(request);
    place += part;
    left -= part;
  }
  if (entry.method == kDeflated && !inflater.ended()) refuse_damaged(request);
  outlet.end();
}

/// Before anything is written: what can be unpacked here, and what is claimed. @return bytes
double check(const Request& request, const std::vector<ZipEntry>& entries, double archive,
             const fs::path& folder) {
  UnpackedFolder measure(request, folder);
  double bytes = 0.0;
  for (const ZipEntry& entry : entries) {
    if ((entry.flags & 1U) != 0)
      refuse(request, "", "is encrypted", "Unpack it with its password and name the folder");
    if (!entry.is_file) continue;
    if (entry.method != kStored && entry.method != kDeflated)
      refuse(request, "", "is packed in a way that is not read here",
             "Unpack it yourself and name the folder");
    measure.spend(static_cast<double>(entry.size), archive);
    bytes += static_cast<double>(entry.size);
  }
  return bytes;
}

}  // namespace

void unpack_zip(const Request& request, const fs::path& folder) {
  ZipBytes bytes(request);
  const std::vector<ZipEntry> entries = zip_directory(request, bytes);
  const double all = std::max(1.0, check(request, entries, static_cast<double>(bytes.size()), folder));
  UnpackedFolder unpacked(request, folder);
  double done = 0.0;
  for (const ZipEntry& entry : entries) {
    if (!entry.is_file) continue;
    unpack_entry(request, bytes, entry, unpacked);
    done += static_cast<double>(entry.size);
    request.progress(std::min(1.0, done / all));
  }
}

}  // namespace glisson::reader
