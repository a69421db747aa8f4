// SPDX-License-Identifier: GPL-3.0-or-later
#include "opencv_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/json_text.h"

namespace glisson::stereo {
namespace {

constexpr const char* kRemedy = "Write the calibration anew or calibrate again";
constexpr std::string_view kBlank = " \t\r\n";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(kBlank) - first + 1));
}

std::string unquoted(std::string text) {
  const bool quoted =
      text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

template <class Number>
bool parse(const std::string& text, Number& value) {
  const char* begin = text.c_str() + (text.starts_with("+") ? 1 : 0);
  const auto [end, failure] = std::from_chars(begin, text.c_str() + text.size(), value);
  return failure == std::errc() && end == text.c_str() + text.size() && begin != end;
}

/// "KEY: REST" at the beginning of a line; nothing: the line is none.
std::optional<std::pair<std::string, std::string>> entry_of(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  if (colon + 1 < line.size() && kBlank.find(line[colon + 1]) == std::string_view::npos) return std::nullopt;
  const std::string key = unquoted(trimmed(line.substr(0, colon)));
  if (key.empty() || key.find_first_of("[]{}\"' ") != std::string::npos) return std::nullopt;
  return std::pair(key, trimmed(line.substr(colon + 1)));
}

/// What is open in a text: brackets that are not closed.
long open_brackets(std::string_view text) {
  return std::count(text.begin(), text.end(), '[') - std::count(text.begin(), text.end(), ']');
}

}  // namespace

OpenCvText::OpenCvText(std::string_view content, std::string name) : name_(std::move(name)) {
  if (content.size() > (1U << 20) || content.find('\0') != std::string_view::npos)
    throw InputError(name_, "", "is not a calibration (too large, or not text)", kRemedy);
  if (trimmed(content).starts_with("<"))
    throw InputError(name_, "", "is XML, which is not read", "Save the calibration as YAML (.yml)");
  if (trimmed(content).starts_with("{"))
    read_json(content);
  else
    read_yaml(content);
}

void OpenCvText::add(const std::string& key, Value value) {
  if (!values_.emplace(key, std::move(value)).second) throw InputError(name_, key, "stands twice", kRemedy);
}

/// Splits a text into entries. Each begins in a line's first column; lines that are indented or within open
/// brackets belong to the one before.
void OpenCvText::read_yaml(std::string_view content) {
  std::string key, field;
  Value value;
  long open = 0;
  const auto fail = [&] {
    throw InputError(name_, "",
                     key.empty() ? std::string("is not valid OpenCV YAML")
                                 : "is not valid OpenCV YAML (at " + key.substr(0, 40) + ")",
                     kRemedy);
  };
  const auto finish = [&] {
    if (open != 0) fail();
    if (!key.empty()) add(key, std::move(value));
    value = {};
    key.clear();
    field.clear();
  };
  std::size_t lines = 0;
  while (!content.empty()) {
    const std::size_t end = std::min(content.find('\n'), content.size());
    const std::string_view line = content.substr(0, end);
    content.remove_prefix(std::min(end + 1, content.size()));
    const std::string text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    const bool first_column = kBlank.find(line.front()) == std::string_view::npos;
    if (first_column && open == 0 && (text.starts_with("%YAML") || text == "---" || text == "...")) continue;
    ++lines;
    if (first_column && open == 0 && !text.starts_with("- ")) {
      finish();
      const auto entry = entry_of(text);
      if (!entry) fail();
      key = entry->first;
      value.is_matrix = entry->second == "!!opencv-matrix";
      value.text = unquoted(entry->second);
      value.is_scalar = !value.is_matrix && !value.text.empty() && open_brackets(value.text) == 0;
      if (!value.is_matrix) open += open_brackets(entry->second);
    } else if (key.empty()) {
      fail();
    } else if (const auto entry = open == 0 ? entry_of(text) : std::nullopt; entry && value.is_matrix) {
      field = entry->first;
      if (!value.fields.emplace(field, entry->second).second) fail();
      open += open_brackets(entry->second);
    } else {
      if (!field.empty()) value.fields[field] += " " + text;
      value.is_scalar = false;
      open += open_brackets(text);
    }
    if (open < 0 || open > 1000) fail();
  }
  finish();
  if (lines == 0) throw InputError(name_, "", "is not an OpenCV YAML file", kRemedy);
}

void OpenCvText::read_json(std::string_view content) {
  nlohmann::json document;
  try {
    document = parse_json(content, name_);
  } catch (const nlohmann::json::exception&) {
    throw InputError(name_, "", "is not valid JSON", kRemedy);
  }
  if (!document.is_object()) throw InputError(name_, "", "is not valid JSON", kRemedy);
  for (const auto& [key, entry] : document.items()) {
    Value value;
    value.is_scalar = entry.is_string() || entry.is_number();
    if (value.is_scalar) value.text = entry.is_string() ? entry.get<std::string>() : entry.dump();
    value.is_matrix = entry.is_object() && entry.contains("type_id") && entry["type_id"] == "opencv-matrix";
    if (value.is_matrix)
      for (const auto& [field, content_of] : entry.items())
        if (const bool flat = std::all_of(content_of.begin(), content_of.end(),
                                          [](const nlohmann::json& one) { return one.is_primitive(); });
            flat && !content_of.is_object())  // what lies deeper would be written out recursively
          value.fields[field] = content_of.is_string() ? content_of.get<std::string>() : content_of.dump();
    add(key, std::move(value));
  }
}

std::optional<std::string> OpenCvText::scalar(const std::string& key) const {
  const auto found = values_.find(key);
  if (found == values_.end() || !found->second.is_scalar) return std::nullopt;
  return found->second.text;
}

Eigen::MatrixXd OpenCvText::matrix(const std::string& key) const {
  const auto found = values_.find(key);
  if (found == values_.end()) throw InputError(name_, key, "is missing", kRemedy);
  const auto refuse = [&](const char* problem) { throw InputError(name_, key, problem, kRemedy); };
  const std::map<std::string, std::string>& fields = found->second.fields;
  const auto field = [&](const char* name) {
    const auto one = fields.find(name);
    return one == fields.end() ? std::string() : one->second;
  };
  int rows = 0, columns = 0;
  if (!found->second.is_matrix || !parse(field("rows"), rows) || !parse(field("cols"), columns))
    refuse("is not a matrix");
  if (rows < 1 || rows > 16 || columns < 1 || columns > 16) refuse("is not a matrix of a calibration's size");
  const std::string type = unquoted(field("dt"));
  if (type.size() != 1 || std::string("ucwsifd").find(type) == std::string::npos)
    refuse("is not a matrix of numbers");
  std::string data = field("data");
  if (data.size() < 2 || data.front() != '[' || data.back() != ']') refuse("is not a matrix");
  data = data.substr(1, data.size() - 2);
  std::replace(data.begin(), data.end(), ',', ' ');
  std::vector<double> numbers;
  for (std::size_t at = 0; (at = data.find_first_not_of(kBlank, at)) != std::string::npos;) {
    const std::size_t end = std::min(data.find_first_of(kBlank, at), data.size());
    double number = 0.0;
    if (!parse(data.substr(at, end - at), number) || !std::isfinite(number))
      refuse("has an entry that is not a number");
    numbers.push_back(number);
    at = end;
  }
  if (static_cast<int>(numbers.size()) != rows * columns)
    refuse("has not as many numbers as it has rows and columns");
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(numbers.data(), rows, columns);
}

}  // namespace glisson::stereo
