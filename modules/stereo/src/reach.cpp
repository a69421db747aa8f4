// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/reach.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include "glisson/core/claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/log_file.h"
#include "glisson/core/output_file.h"
#include "glisson/stereo/source.h"

namespace glisson::stereo {
namespace {

namespace fs = std::filesystem;

bool is_number(std::string_view text) {
  return !text.empty() && text.size() <= 3 && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Empty: there is no place for it.
fs::path list_of_sources() {
  const fs::path folder = state_folder();
  return folder.empty() ? fs::path() : folder / "known_sources";
}

/// The latest last.
std::vector<std::string> entered_sources() {
  std::vector<std::string> sources;
  std::error_code ignored;
  if (!fs::is_regular_file(list_of_sources(), ignored)) return sources;
  try {
    std::istringstream lines(read_file(list_of_sources()));
    for (std::string line; std::getline(lines, line);) sources.push_back(line);
  } catch (const FileError&) {
    sources.clear();  // not readable: nobody has entered anything
  }
  return sources;
}

/// As the list names it: a file by where it really is, so that it does not matter how it was reached.
std::string entry_of(const std::string& source) {
  if (is_live(source) || !stays_here(source)) return source;
  std::error_code failure;
  const fs::path whole = fs::absolute(source, failure);
  if (failure) return source;
  const fs::path real = fs::weakly_canonical(whole, failure);
  const fs::path path = failure ? whole.lexically_normal() : real;
  return (path.has_filename() ? path : path.parent_path()).string();  // a folder with or without its slash
}

/// Only the user's own, from its first byte on. @throws FileError, std::filesystem::filesystem_error.
void write_list(const fs::path& list, const std::vector<std::string>& entries) {
  constexpr fs::perms kOwn = fs::perms::owner_read | fs::perms::owner_write;
  const fs::path folder = list.parent_path();
  if (fs::create_directories(folder)) fs::permissions(folder, fs::perms::owner_all);
  if (fs::exists(list)) fs::permissions(list, kOwn);  // what takes its place has the same
  sweep_leftovers(folder);                            // of programs that were killed at it
  OutputFile file(list);
  fs::permissions(file.path(), kOwn);
  std::string lines;
  for (const std::string& entry : entries) lines += entry + '\n';
  file.write(lines);
  file.commit();
}

}  // namespace

bool stays_here(std::string_view source) {
  // Of this computer, too: a case must not make the program connect.
  if (is_igtl(source)) return false;
  if (!is_device(source)) return source.find("://") == std::string_view::npos;
  const std::string device = device_of(source);
  constexpr std::string_view kNode = "/dev/video";
  return is_number(device) || (device.starts_with(kNode) && is_number(device.substr(kNode.size())));
}

void remember_sources(const std::vector<std::string>& sources) {
  constexpr std::ptrdiff_t kMost = 1000;
  if (list_of_sources().empty()) return;
  const std::vector<std::string> before = entered_sources();
  std::vector<std::string> now = before;
  for (const std::string& source : sources) {
    const std::string entry = source.empty() ? source : entry_of(source);
    if (entry.empty() || entry.find('\n') != std::string::npos) continue;
    std::erase(now, entry);
    now.push_back(entry);
  }
  if (std::ssize(now) > kMost) now.erase(now.begin(), now.end() - kMost);
  if (now == before) return;
  try {
    write_list(list_of_sources(), now);
  } catch (const std::exception&) {
    return;  // it is asked for again
  }
}

bool is_entered(const std::string& source) {
  const std::vector<std::string> entered = entered_sources();
  return std::find(entered.begin(), entered.end(), entry_of(source)) != entered.end();
}

SourceOptions read_entered_source(const fs::path& path) {
  SourceOptions options = read_source(path);
  for (const auto& [field, source] : {std::pair("left", options.left), std::pair("right", options.right)})
    if (!stays_here(source) && !is_entered(source))
      throw InputError(path.string(), field,
                       "names a source outside this computer (" + source.substr(0, 200) + ")",
                       "Enter that source yourself where pictures are opened, if you trust it");
  return options;
}

void require_known_scheme(std::string_view source) {
  const std::string device = is_device(source) ? device_of(source) : std::string(source);
  const std::size_t end = device.find("://");
  if (end == std::string::npos || device.find('!') != std::string::npos) return;  // a pipeline has its own
  const std::string scheme = lower_case(device.substr(0, end));
  for (const char* known : {"rtsp", "rtsps", "rtp", "srt", "udp", "http", "https"})
    if (scheme == known) return;
  throw InputError(std::string(source), "", "is an address of a kind that is not opened",
                   "Use rtsp, rtsps, rtp, srt, udp, http or https");
}

bool begins_as_video(std::string_view begin) {
  using namespace std::string_view_literals;
  for (const std::string_view mark :
       {"\x1A\x45\xDF\xA3"sv, "\x30\x26\xB2\x75"sv, "OggS"sv, "FLV\x01"sv, "DKIF"sv, "\x06\x0E\x2B\x34"sv,
        "\x00\x00\x01\xBA"sv, "\x00\x00\x01\xB3"sv, "\x00\x00\x00\x01"sv, "\x00\x00\x01\x67"sv,
        "YUV4MPEG2 "sv})
    if (begin.starts_with(mark)) return true;
  if (begin.starts_with("RIFF")) return begin.size() >= 12 && begin.substr(8, 4) == "AVI ";
  for (const char* box : {"ftyp", "moov", "mdat", "free", "skip", "wide"})  // MP4 and QuickTime
    if (begin.size() >= 8 && begin.substr(4, 4) == box) return true;
  return !begin.empty() &&
         (begin[0] == '\x47' || (begin.size() > 4 && begin[4] == '\x47'));  // transport stream
}

}  // namespace glisson::stereo
