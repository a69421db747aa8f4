// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/json_file.h"

#include <cmath>
#include <cstdint>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_text.h"
#include "nesting.h"

namespace glisson {
namespace {
constexpr const char* kTooDeep = "nests lists deeper than any that is read here";

/// A name that stands twice in one object of a JSON text. By the text: the library's own way to look at names
/// takes as long again as all its parsing.
/// @pre it has been parsed
std::optional<std::string> named_twice(std::string_view json) {
  json = json.substr(0, json.find('\0'));    // there the library ends
  std::vector<std::set<std::string>> names;  // of each object and list that is open
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] == '{' || json[i] == '[') names.emplace_back();
    if (json[i] == '}' || json[i] == ']') names.pop_back();
    if (json[i] != '"') continue;
    const std::size_t begin = i + 1;
    bool is_escaped = false;
    for (++i; i < json.size() && json[i] != '"'; ++i)
      if (json[i] == '\\') {
        is_escaped = true;
        ++i;
      }
    const std::size_t next = json.find_first_not_of(" \t\r\n", i + 1);
    if (next == std::string_view::npos || json[next] != ':') continue;  // a text, no name
    std::string name(json.substr(begin, i - begin));
    if (is_escaped) name = nlohmann::json::parse('"' + name + '"').get<std::string>();
    if (!names.back().insert(name).second) return name;
  }
  return {};
}
}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& name) {
  if (nests_too_deep(text)) throw InputError(name, "", kTooDeep, "Write the file anew");
  nlohmann::json document = nlohmann::json::parse(text);
  if (const std::optional<std::string> twice = named_twice(text))
    throw InputError(name, nlohmann::json(*twice).dump(), "stands twice", "Keep one of them");
  return document;
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::error_code unknown;
  if (const auto size = std::filesystem::file_size(path, unknown); !unknown && size > kMostJsonBytes)
    throw InputError(path.string(), "", "is larger than 100 MB, more than any list needs",
                     "Check that this is the right file");
  const std::string text = read_file(path, kMostJsonBytes);
  try {
    return parse_json(text, path.string());
  } catch (const nlohmann::json::parse_error& failure) {
    std::size_t line = 1, column = 1;
    for (std::size_t i = 0; i + 1 < failure.byte && i < text.size(); ++i) {
      column = text[i] == '\n' ? 1 : column + 1;
      line += text[i] == '\n';
    }
    throw InputError(path.string(), "line " + std::to_string(line) + ", column " + std::to_string(column),
                     "is not valid JSON", "Correct it there or write the file anew");
  } catch (const nlohmann::json::exception&) {
    throw InputError(path.string(), "", "holds a number that is larger than any", "Write the file anew");
  }
}

void for_each_json_line(const std::filesystem::path& path, const char* remedy,
                        const std::function<void(const nlohmann::json&)>& take) {
  std::istringstream lines(read_file(path));
  int count = 0;
  for (std::string text; std::getline(lines, text);) {
    const std::string line = "line " + std::to_string(++count);
    if (text.empty()) continue;
    try {
      take(parse_json(text, path.string()));
    } catch (const InputError& error) {
      const std::string field = error.field().empty() ? line : line + ", " + error.field();
      throw InputError(path.string(), field, error.problem(), error.remedy());
    } catch (const std::exception& failure) {
      throw InputError(path.string(), line, std::string("is malformed (") + failure.what() + ")", remedy);
    }
  }
}

void write_json(const std::filesystem::path& path, const nlohmann::json& document) {
  write_file_atomically(path, document.dump(2) + "\n");
}

void write_figures(const std::filesystem::path& path, const Figures& figures,
                   const std::map<std::string, std::string>& texts) {
  nlohmann::json document = nlohmann::json::object();
  for (const auto& [key, text] : texts) document[key] = text;
  for (const auto& [key, value] : figures) {
    // Counts look like counts: 550, not 550.0. Doubles hold whole numbers exactly up to 2^53.
    if (std::isfinite(value) && value == std::trunc(value) && std::abs(value) < 9007199254740992.0)
      document[key] = static_cast<std::int64_t>(value);
    else if (std::isfinite(value))
      document[key] = value;
    else
      document[key] = nullptr;
  }
  write_json(path, document);
}

}  // namespace glisson
