// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// @file
/// The plan (house.txt) and the disk, for the tests that hold them against each other.

namespace glisson::house {

using Rooms = std::set<std::string>;

/// The plan. Rooms of modules/ go by their name alone, others by their path ("ui/scene", "app").
struct Plan {
  std::map<std::string, Rooms> sees;  ///< of each room, beside itself
  Rooms millimetres;                  ///< rooms with names in _mm in their public headers
  Rooms any_frame;                    ///< rooms whose points are in whichever frame their caller's are
};

/// @throws std::runtime_error with the line: neither ":" nor "=", a room twice, a room that no line before
/// names. So a plan has no cycle.
inline Plan read_plan(std::istream& stream) {
  Plan plan;
  std::map<std::string, Rooms> lists;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const auto refuse = [&](const std::string& why) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + why);
    };
    line = line.substr(0, line.find('#'));
    if (std::all_of(line.begin(), line.end(), [](unsigned char c) { return std::isspace(c); })) continue;
    std::istringstream words(line);
    std::string name, sign, word;
    words >> name >> sign;
    if (sign != ":" && sign != "=") refuse("is neither 'ROOM : ...' nor 'LIST = ...'");
    if (plan.sees.contains(name) || lists.contains(name)) refuse(name + " is there twice");
    Rooms rooms;
    while (words >> word) {
      if (lists.contains(word))
        rooms.insert(lists[word].begin(), lists[word].end());
      else if (plan.sees.contains(word))
        rooms.insert(word);
      else
        refuse(word + " is not above");
    }
    (sign == ":" ? plan.sees : lists)[name] = rooms;
  }
  plan.millimetres = lists["millimetres"];
  plan.any_frame = lists["any_frame"];
  return plan;
}

inline std::filesystem::path source_root() {
  return std::filesystem::path(qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString());
}

inline const Plan& plan() {
  static const Plan kPlan = [] {
    std::ifstream stream(source_root() / "tests/architecture/house.txt");
    if (!stream) throw std::runtime_error("tests/architecture/house.txt is missing");
    return read_plan(stream);
  }();
  return kPlan;
}

inline bool is_source(const std::filesystem::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}

/// Every source below a folder.
inline std::vector<std::filesystem::path> sources_below(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_source(entry.path())) sources.push_back(entry.path());
  return sources;
}

/// Every source of every room, by room. A folder without sources is no room.
inline std::map<std::string, std::vector<std::filesystem::path>> rooms_on_disk() {
  namespace fs = std::filesystem;
  std::map<std::string, std::vector<fs::path>> rooms;
  const auto add = [&](const std::string& name, const fs::path& folder) {
    if (auto sources = sources_below(folder); !sources.empty()) rooms[name] = std::move(sources);
  };
  for (const auto& room : fs::directory_iterator(source_root() / "modules"))
    if (room.is_directory()) add(room.path().filename().string(), room.path());
  for (const auto& room : fs::directory_iterator(source_root() / "ui"))
    if (room.is_directory()) add("ui/" + room.path().filename().string(), room.path());
  add("app", source_root() / "app");
  return rooms;
}

inline bool is_module(const std::string& room) { return room != "app" && !room.starts_with("ui/"); }

/// The public headers of the modules, by room. @param with_window those of the window's rooms, too.
inline std::map<std::string, std::vector<std::filesystem::path>> public_headers(bool with_window = false) {
  std::map<std::string, std::vector<std::filesystem::path>> headers;
  for (const auto& [room, sources] : rooms_on_disk())
    for (const auto& source : sources)
      if ((is_module(room) || (with_window && room != "app")) &&
          source.string().find("/include/") != std::string::npos)
        headers[room].push_back(source);
  return headers;
}

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Source text without comments and strings; lines stay lines.
inline std::string code_in(const std::string& text) {
  static const std::regex kProse("//[^\\n]*|\"(\\\\.|[^\"\\\\\\n])*\"");
  return std::regex_replace(text, kProse, "");
}
inline std::string code_of(const std::filesystem::path& path) { return code_in(text_of(path)); }

}  // namespace glisson::house
