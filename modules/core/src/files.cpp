// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "glisson/core/error.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

/// Removes the temporary file unless it was renamed.
struct Leftover {
  fs::path path;
  ~Leftover() {
    std::error_code ignored;
    if (!path.empty()) fs::remove(path, ignored);
  }
};

fs::path beside(const fs::path& path) {
  // Keeps the extension: many writers choose their format by it.
  return path.parent_path() /
         ("." + path.stem().string() + ".writing" + std::to_string(::getpid()) + path.extension().string());
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string lower_name(const fs::path& path) { return lower_case(path.filename().string()); }
std::string lower_extension(const fs::path& path) { return lower_case(path.extension().string()); }

std::string read_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw FileError(path.string() + ": is a folder. Name a file in it.");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw FileError(path.string() + ": cannot be opened (" + std::strerror(errno) + "). Check the path.");
  std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (stream.bad()) throw FileError(path.string() + ": could not be read to its end. Check the disk.");
  return content;
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
  std::error_code failure;
  if (!fs::is_directory(folder_of(path), failure))
    throw FileError(path.string() + ": its folder does not exist. Create it or choose another.");
  Leftover temporary{beside(path)};
  write(temporary.path);
  if (!fs::exists(temporary.path, failure))
    throw FileError(path.string() + ": could not be written. Check permissions and space.");
  flush_to_disk(temporary.path);
  verify(temporary.path);
  fs::rename(temporary.path, path, failure);
  if (failure) throw FileError(path.string() + ": could not be replaced (" + failure.message() + ").");
  temporary.path.clear();
  flush_to_disk(folder_of(path));
}

void write_file_atomically(const fs::path& path, const std::string& content) {
  write_file_atomically(
      path,
      [&](const fs::path& to) {
        std::ofstream stream(to, std::ios::binary | std::ios::trunc);
        stream.write(content.data(), static_cast<std::streamsize>(content.size()));
        stream.close();
        if (!stream)
          throw FileError(path.string() + ": could not be written. Check permissions and free space.");
      },
      [&](const fs::path& written) {
        if (read_file(written) != content)
          throw FileError(path.string() + ": what was written reads back differently. Check the disk.");
      });
}

TemporaryFolder::TemporaryFolder(const fs::path& beside_folder) {
  const fs::path base = beside_folder.empty() ? fs::temp_directory_path() : beside_folder;
  std::string pattern = (base / ".glisson-XXXXXX").string();
  std::vector<char> buffer(pattern.begin(), pattern.end());
  buffer.push_back('\0');
  if (::mkdtemp(buffer.data()) == nullptr)
    throw FileError(base.string() + ": no folder can be made here (" + std::strerror(errno) +
                    "). Check permissions.");
  path_ = buffer.data();
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace glisson
