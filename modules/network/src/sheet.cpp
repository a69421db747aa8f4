// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet.h"

#include <cmath>
#include <sstream>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"

namespace glisson::network {
namespace {

std::string range_text(double low, double high) {
  std::ostringstream text;
  text << low << " to " << high;
  return text.str();
}

bool is_between(const nlohmann::json& value, double low, double high) {
  return value.is_number() && value.get<double>() >= low && value.get<double>() <= high;
}

}  // namespace

std::filesystem::path sheet_of(const std::filesystem::path& network) {
  std::filesystem::path path = network;
  return path.replace_extension(".json");
}

Sheet::Sheet(const std::filesystem::path& path) : path_(path.string()) {
  std::error_code failure;
  if (!std::filesystem::exists(path, failure))
    refuse("", "does not exist", "Write the network's sheet beside it (see the manual)");
  document_ = read_json(path);
  if (!document_.is_object()) refuse("", "is not a JSON object", "Write {\"channels\": [...], ...}");
}

const nlohmann::json* Sheet::find(const char* field) {
  known_.insert(field);
  const auto found = document_.find(field);
  return found == document_.end() ? nullptr : &*found;
}

std::optional<double> Sheet::number(const char* field, double low, double high) {
  const nlohmann::json* value = find(field);
  if (value == nullptr) return {};
  if (!is_between(*value, low, high))
    refuse(field, "is no number from " + range_text(low, high), "Write a number");
  return value->get<double>();
}

std::optional<std::vector<double>> Sheet::numbers(const char* field, double low, double high) {
  const nlohmann::json* value = find(field);
  if (value == nullptr) return {};
  bool good = value->is_array();
  for (std::size_t n = 0; good && n < value->size(); ++n) good = is_between((*value)[n], low, high);
  if (!good)
    refuse(field, "holds what is no number from " + range_text(low, high), "Write a list of numbers");
  return value->get<std::vector<double>>();
}

std::optional<std::string> Sheet::text(const char* field) {
  const nlohmann::json* value = find(field);
  if (value == nullptr) return {};
  if (!value->is_string()) refuse(field, "is no text", "Write a text in quotes");
  return value->get<std::string>();
}

std::optional<std::vector<std::string>> Sheet::texts(const char* field) {
  const nlohmann::json* value = find(field);
  if (value == nullptr) return {};
  bool good = value->is_array();
  for (std::size_t n = 0; good && n < value->size(); ++n) good = (*value)[n].is_string();
  if (!good) refuse(field, "holds what is no text", "Write a list of texts in quotes");
  return value->get<std::vector<std::string>>();
}

void Sheet::no_other_fields() const {
  for (const auto& [field, value] : document_.items())
    if (!known_.contains(field)) {
      std::string list;
      for (const std::string& one : known_) list += (list.empty() ? "" : ", ") + one;
      refuse(field, "is no field of a network's sheet", "Take one of " + list);
    }
}

void Sheet::refuse(const std::string& field, const std::string& problem, const std::string& remedy) const {
  throw InputError(path_, field, problem, remedy);
}

}  // namespace glisson::network
