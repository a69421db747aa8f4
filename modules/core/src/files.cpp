// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/files.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/output_file.h"

namespace glisson {
namespace fs = std::filesystem;

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string lower_name(const fs::path& path) { return lower_case(path.filename().string()); }
std::string lower_extension(const fs::path& path) { return lower_case(path.extension().string()); }

std::string read_file(const fs::path& path, std::size_t most_bytes) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw FileError(path.string() + ": is a folder. Name a file in it.");
  // A pipe that nobody writes to is at its end at once, where opening it would wait for one who does.
  const Claim file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.descriptor() < 0)
    throw FileError(path.string() + ": cannot be opened (" + std::strerror(errno) + "). Check the path.");
  // A pipe or a device has no size and perhaps no end: counted while it is read.
  std::string content;
  std::vector<char> part(1 << 20);
  for (;;) {
    const ssize_t got = ::read(file.descriptor(), part.data(), part.size());
    if (got == 0) return content;
    if (got < 0 && errno == EAGAIN) {
      pollfd waited{file.descriptor(), POLLIN, 0};
      if (::poll(&waited, 1, -1) > 0) continue;
    }
    if (got < 0) throw FileError(path.string() + ": could not be read to its end. Check the disk.");
    content.append(part.data(), static_cast<std::size_t>(got));
    if (content.size() > most_bytes)
      throw FileError(path.string() + (most_bytes == kMostFileBytes
                                           ? ": is larger than 4 GB. Check that this is the right file."
                                           : ": is larger than such a file can be. Check that this is "
                                             "the right file."));
  }
}

void flush_to_disk(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    throw FileError(path.string() + ": cannot be opened to flush (" + std::strerror(errno) + ").");
  const int result = ::fsync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  if (result != 0 && reason != EINVAL && reason != EROFS)
    throw FileError(path.string() + ": could not be flushed to disk (" + std::strerror(reason) +
                    "). Free some space.");
}

void write_file_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write,
                           const std::function<void(const fs::path&)>& verify) {
  OutputFile file(path);
  write(file.path());
  std::error_code failure;
  if (fs::file_size(file.path(), failure) == 0 || failure)
    throw FileError(path.string() + ": could not be written. Check permissions and space.");
  flush_to_disk(file.path());
  verify(file.path());
  file.commit();
}

void write_file_atomically(const fs::path& path, const std::string& content) {
  OutputFile file(path);
  file.write(content);
  flush_to_disk(file.path());
  if (read_file(file.path()) != content)
    throw FileError(path.string() + ": what was written reads back differently. Check the disk.");
  file.commit();
}

fs::path work_folder() {
  const auto named = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value == nullptr ? "" : value);
  };
  std::error_code failure;
  const fs::path shared = fs::temp_directory_path(failure);
  if (!named("TMPDIR").empty() && !failure) return shared;
  const fs::path home = named("HOME"), cache = named("XDG_CACHE_HOME");
  const fs::path root = cache.is_absolute() ? cache : home / ".cache";
  if (!root.is_absolute()) return shared;
  const fs::path folder = root / "glisson" / "work";
  fs::create_directories(folder, failure);
  if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
  return failure || ::access(folder.c_str(), W_OK) != 0 ? shared : folder;
}

TemporaryFolder::TemporaryFolder(const fs::path& beside_folder) {
  const fs::path base = beside_folder.empty() ? work_folder() : beside_folder;
  path_ = Claim::make_folder(base, claim_);
  if (path_.empty())
    throw FileError(base.string() + ": no folder can be made here (" + std::strerror(errno) +
                    "). Check permissions.");
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace glisson
