// SPDX-License-Identifier: GPL-3.0-or-later
#include "script_entry.h"

#include <cmath>

#include "glisson/core/error.h"

namespace glisson::editing {
namespace {

using nlohmann::json;

/// Dividing is rounded rightly, so that 789 mm are the metres that a program calls 0.789.
double in_metres(double mm) { return mm / 1e3; }

}  // namespace

double in_mm(double metres) {
  const double mm = 1e3 * metres;
  for (const double candidate :
       {std::round(mm * 1e6) / 1e6, mm, std::nextafter(mm, 1e300), std::nextafter(mm, -1e300)})
    if (in_metres(candidate) == metres) return candidate;
  return mm;
}

json in_mm(const Eigen::Vector3d& p) { return {in_mm(p.x()), in_mm(p.y()), in_mm(p.z())}; }

ScriptEntry::ScriptEntry(const json& object, std::string file, std::string where)
    : object_(object), file_(std::move(file)), where_(std::move(where)) {
  if (!object.is_object())
    throw InputError(file_, where_, "is not a JSON object", R"(Write {"tool": ..., ...})");
}

void ScriptEntry::refuse(const std::string& key, const std::string& problem,
                         const std::string& remedy) const {
  throw InputError(file_, where_ + ", " + key, problem, remedy);
}

bool ScriptEntry::has(const std::string& key) {
  known_.insert(key);
  return object_.contains(key);
}

const json& ScriptEntry::at(const std::string& key) {
  if (!has(key)) refuse(key, "is missing", "Add it");
  return object_.at(key);
}

double ScriptEntry::metres(const std::string& key) { return in_metres(number(key)); }

int ScriptEntry::integer(const std::string& key) {
  const json& value = at(key);
  if (!value.is_number_integer() || value < -1000 || value > 1000)
    refuse(key, "is " + value.dump() + ", which is no small whole number", "Write a whole number");
  return value;
}

bool ScriptEntry::flag(const std::string& key) {
  if (!has(key)) return false;
  const json& value = object_.at(key);
  if (!value.is_boolean()) refuse(key, "is " + value.dump(), "Write true or false");
  return value;
}

std::string ScriptEntry::text(const std::string& key) {
  const json& value = at(key);
  if (!value.is_string()) refuse(key, "is " + value.dump() + ", which is no text", "Write a name in quotes");
  return value;
}

void ScriptEntry::refuse_choice(const std::string& key, const std::string& wanted,
                                const std::vector<std::string>& words) const {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  refuse(key, "is \"" + wanted + "\"", "Take one of " + list);
}

std::vector<Label> ScriptEntry::labels(const std::string& key) {
  std::vector<Label> all;
  for (const json& value : list(key)) all.push_back(label_in(value, key));
  return all;
}

Eigen::Vector3d ScriptEntry::point(const std::string& key) {
  return Eigen::Vector3d(row(key, 3).data()) / 1e3;
}

std::vector<double> ScriptEntry::rows(const std::string& key, std::size_t columns) {
  std::vector<double> all;
  for (const json& value : list(key)) {
    const std::vector<double> numbers = row_in(value, key, columns);
    all.insert(all.end(), numbers.begin(), numbers.end());
  }
  return all;
}

void ScriptEntry::finish() const {
  for (const auto& [key, value] : object_.items())
    if (!known_.contains(key))
      refuse(key, "is no field that is known here", "Remove it, or correct its name");
}

const json& ScriptEntry::list(const std::string& key) {
  const json& value = at(key);
  if (!value.is_array()) refuse(key, "is not a list", "Write it in square brackets");
  return value;
}

double ScriptEntry::number_in(const json& value, const std::string& key) const {
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    refuse(key, "is " + value.dump() + ", which is no number", "Write a number");
  return value;
}

Label ScriptEntry::label_in(const json& value, const std::string& key) const {
  const std::optional<Label> label =
      value.is_string() ? structure_named(value.get<std::string>()) : std::nullopt;
  if (!label)
    refuse(key, "is " + value.dump() + ", which is no structure",
           "Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder, "
           "lesion_1, other_1 and so on");
  return *label;
}

std::vector<double> ScriptEntry::row_in(const json& value, const std::string& key,
                                        std::size_t columns) const {
  if (!value.is_array() || value.size() != columns)
    refuse(key, "is not made of " + std::to_string(columns) + " numbers each", "Write lists of numbers");
  std::vector<double> numbers;
  for (const json& each : value) numbers.push_back(number_in(each, key));
  return numbers;
}

}  // namespace glisson::editing
