// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_manifest.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/core/word_sum.h"
#include "glisson/engine/part.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// More than any file that is read whole, and so than any that a case can be opened with.
constexpr std::uintmax_t kMostPartBytes = kMostFileBytes + 1'000'000'000;

/// Whether a name is one that this or an earlier edition gives to a file of a case.
bool is_of_layout(const fs::path& relative) {
  if (relative == kCaseFile) return true;
  const std::vector<std::string_view> files = files_of_parts();
  return std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    if (file.stem() != "*") return relative == file;
    return relative.parent_path() == file.parent_path() && relative.extension() == file.extension();
  });
}

/// What the former save says that it wrote; null: it was of an edition that said nothing.
json files_of(const fs::path& former) {
  try {
    const json document = read_json(former / kCaseFile);
    if (document.is_object() && document.contains("files") && document["files"].is_object())
      return document["files"];
  } catch (const Error&) {
  }
  return nullptr;
}

fs::path unused_name(const fs::path& wanted) {
  for (int number = 1;; ++number) {
    fs::path name = wanted;
    name += ".kept-" + std::to_string(number);
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(name, ignored))) return name;
  }
}

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw FileError(path.string() + ": is no file of the case and could not be kept (" + reason +
                  "). Move it elsewhere and save again; the old case stands.");
}

void link_or_copy(const fs::path& from, const fs::path& to) {
  if (::linkat(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), 0) == 0) return;
  const std::string reason = std::strerror(errno);
  std::error_code failure;
  const fs::file_status status = fs::symlink_status(from, failure);
  if (fs::is_symlink(status))
    fs::copy_symlink(from, to, failure);
  else if (fs::is_regular_file(status))
    fs::copy_file(from, to, failure);
  else
    refuse(from, reason);
  if (failure) refuse(from, failure.message());
}

/// Folders that are nobody's but the person's, made anew around what is carried over from them.
class CarriedFolders {
 public:
  CarriedFolders(const fs::path& former, const fs::path& fresh) : former_(former), fresh_(fresh) {}

  /// With those around it.
  void make(const fs::path& relative) {
    fs::path part;
    for (const fs::path& name : relative) {
      part /= name;
      if (fs::exists(fs::symlink_status(fresh_ / part))) continue;
      if (::mkdir((fresh_ / part).c_str(), 0700) != 0) refuse(former_ / part, std::strerror(errno));
      made_.push_back(part);
    }
  }
  /// Once all lies in them: they are as private, as old and as much another's as they were.
  void finish() const {
    for (auto part = made_.rbegin(); part != made_.rend(); ++part) {
      const fs::path now = fresh_ / *part;
      struct stat was = {};
      if (::stat((former_ / *part).c_str(), &was) != 0) continue;
      (void)!::chown(now.c_str(), was.st_uid, was.st_gid);  // root alone may do that
      if (::chmod(now.c_str(), was.st_mode & 07777U) != 0) refuse(former_ / *part, std::strerror(errno));
      const std::array<timespec, 2> times = {was.st_atim, was.st_mtim};
      ::utimensat(AT_FDCWD, now.c_str(), times.data(), 0);
    }
  }

 private:
  const fs::path& former_;
  const fs::path& fresh_;
  std::vector<fs::path> made_;  ///< outer ones first
};

/// A link, a file, a pipe. @return its name in `fresh` where that is another than it had; empty: the same, or
/// it is the former save's own.
fs::path carry(const fs::directory_entry& entry, const fs::path& relative, const fs::path& fresh,
               const json& listed, CarriedFolders& folders) {
  const fs::file_status status = entry.symlink_status();
  const fs::path target = fresh / relative;
  const std::string name = relative.string();
  if (name == kCaseFile || (listed.is_null() && is_of_layout(relative))) return {};
  const bool was_ours = listed.contains(name);
  if (was_ours && fs::is_regular_file(status) && listed[name] == sum_of(entry.path())) return {};
  std::error_code failure;
  const bool needs_name =
      was_ours || is_of_layout(relative) || fs::exists(fs::symlink_status(target, failure));
  const fs::path kept = needs_name ? unused_name(target) : target;
  folders.make(relative.parent_path());
  link_or_copy(entry.path(), kept);
  return needs_name ? kept.lexically_relative(fresh) : fs::path();
}

}  // namespace

std::string sum_of(const fs::path& path) {
  // A file with holes has any size: what no part can have written is summed by nobody.
  std::error_code failure;
  if (fs::file_size(path, failure) > kMostPartBytes || failure) return {};
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> buffer(std::size_t{1} << 20U);
  WordSum sum;
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    sum.add({buffer.data(), static_cast<std::size_t>(stream.gcount())});
  }
  return stream.bad() || !stream.eof() ? std::string() : sum.text();
}

json list_files(const fs::path& folder) {
  json files = json::object();
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = sum_of(entry.path());
  files.erase(kCaseFile);
  return files;
}

std::string sum_as_listed(const fs::path& folder, const std::string& name) {
  const json listed = files_of(folder);
  if (!listed.contains(name)) return {};
  const std::string sum = sum_of(folder / name);
  return listed[name] == sum ? sum : std::string();
}

std::vector<std::string> changed_files(const fs::path& folder, const json& document,
                                       const RunContext& context) {
  std::vector<std::string> changed;
  const auto files = document.find("files");
  if (files == document.end() || !files->is_object()) return changed;
  for (const auto& [name, sum] : files->items()) {
    const fs::path relative = fs::path(name).lexically_normal();
    // What is no file of a part ("../mesh.vtu" neither) is not opened, whatever the list says.
    if (!is_of_layout(relative)) continue;
    if (context.cancelled()) break;
    std::error_code failure;
    if (!fs::is_regular_file(folder / relative, failure) || sum != sum_of(folder / relative))
      changed.push_back(name);
  }
  return changed;
}

std::vector<std::string> carry_over(const fs::path& former, const fs::path& fresh) {
  const json listed = files_of(former);
  std::vector<std::string> changed;
  CarriedFolders folders(former, fresh);
  std::error_code failure;
  fs::path at = former;
  auto entry = fs::recursive_directory_iterator(former, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    at = entry->path();
    const fs::path relative = at.lexically_relative(former);
    if (fs::is_directory(entry->symlink_status())) {
      if (fs::is_empty(at, failure)) folders.make(relative);
      if (failure) break;
      continue;
    }
    const fs::path kept = carry(*entry, relative, fresh, listed, folders);
    if (!kept.empty()) changed.push_back(kept.string());
  }
  if (failure) refuse(at, failure.message());
  folders.finish();
  return changed;
}

}  // namespace glisson::engine
