// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <sstream>

#include "glisson/core/error.h"
#include "raw_volume.h"

namespace glisson::reader {
namespace {

constexpr std::size_t kLongestHeader = 1u << 16;

/// "key = value" lines up to ElementDataFile, which ends a MetaImage header; `end` is set to where it ends.
std::map<std::string, std::string> keys_of(std::istream& stream, std::size_t& end) {
  std::map<std::string, std::string> keys;
  std::string line;
  end = 0;
  while (end < kLongestHeader && std::getline(stream, line)) {
    end += line.size() + 1;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    std::istringstream key(line.substr(0, equals));
    std::string name;
    key >> name;
    const std::size_t first = line.find_first_not_of(' ', equals + 1);
    keys[name] = first == std::string::npos ? "" : line.substr(first);
    if (name == "ElementDataFile") break;
  }
  return keys;
}

}  // namespace

void check_meta_complete(const Request& request, std::uintmax_t bytes) {
  std::ifstream stream(request.path, std::ios::binary);
  std::size_t end = 0;
  const std::map<std::string, std::string> keys = keys_of(stream, end);
  const auto value = [&](const char* key) {
    const auto found = keys.find(key);
    return found == keys.end() ? std::string() : found->second;
  };
  const std::string place = value("ElementDataFile");
  if (place.empty() || place.find("LIST") == 0 || place.find('%') != std::string::npos)
    throw InputError(request.name, "ElementDataFile", "names no single file of voxels",
                     "Export the volume as one .mha file");
  const bool local = place == "LOCAL" || place == "Local" || place == "local";
  const std::filesystem::path file = local ? request.path : request.path.parent_path() / place;
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (failure)
    throw InputError(request.name, "ElementDataFile", "names " + place + ", which is missing",
                     "Put it beside the header");
  std::uintmax_t expected = bytes;
  const std::string compressed = value("CompressedData");
  if (!compressed.empty() && (compressed[0] == 'T' || compressed[0] == 't' || compressed[0] == '1')) {
    expected = 0;
    std::istringstream(value("CompressedDataSize")) >> expected;
  }
  if (size < expected + (local ? end : 0))
    throw InputError(request.name, "voxels", "end early: the file is damaged", "Export it again");
}

}  // namespace glisson::reader
