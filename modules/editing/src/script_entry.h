// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/patient/label_map.h"

namespace glisson::editing {

/// The words of a choice, in the order of its values.
template <class E>
using Names = std::vector<std::pair<const char*, E>>;

template <class E>
std::string name_of(const Names<E>& names, E value) {
  for (const auto& [name, each] : names)
    if (each == value) return name;
  return "";
}
template <class E>
std::vector<std::string> words_of(const Names<E>& names) {
  std::vector<std::string> words;
  for (const auto& [name, value] : names) words.emplace_back(name);
  return words;
}

/// A number of millimetres that reads back as the same number of metres where there is one.
double in_mm(double metres);
nlohmann::json in_mm(const Eigen::Vector3d& p);

/// One object of a script. Every question names the field in its refusal; what was not asked for is refused.
class ScriptEntry {
 public:
  /// @throws InputError naming `where`: it is no object.
  ScriptEntry(const nlohmann::json& object, std::string file, std::string where);

  [[noreturn]] void refuse(const std::string& key, const std::string& problem,
                           const std::string& remedy) const;
  bool has(const std::string& key);
  const nlohmann::json& at(const std::string& key);
  ScriptEntry object(const std::string& key) { return {at(key), file_, where_ + ", " + key}; }

  double number(const std::string& key) { return number_in(at(key), key); }
  double metres(const std::string& key);
  int integer(const std::string& key);
  /// False where it is not there.
  bool flag(const std::string& key);
  std::string text(const std::string& key);
  template <class E>
  E one_of(const std::string& key, const Names<E>& names) {
    const std::string wanted = text(key);
    for (const auto& [name, value] : names)
      if (wanted == name) return value;
    refuse_choice(key, wanted, words_of(names));
  }
  [[noreturn]] void refuse_choice(const std::string& key, const std::string& wanted,
                                  const std::vector<std::string>& words) const;
  Label label(const std::string& key) { return label_in(at(key), key); }
  std::vector<Label> labels(const std::string& key);
  Eigen::Vector3d point(const std::string& key);
  /// A list of `columns` numbers.
  std::vector<double> row(const std::string& key, std::size_t columns) {
    return row_in(at(key), key, columns);
  }
  /// A list of lists of `columns` numbers, row by row.
  std::vector<double> rows(const std::string& key, std::size_t columns);
  /// @throws InputError there is a field that nobody asked for.
  void finish() const;

 private:
  const nlohmann::json& list(const std::string& key);
  double number_in(const nlohmann::json& value, const std::string& key) const;
  Label label_in(const nlohmann::json& value, const std::string& key) const;
  std::vector<double> row_in(const nlohmann::json& value, const std::string& key, std::size_t columns) const;

  const nlohmann::json& object_;
  std::string file_, where_;
  std::set<std::string> known_;
};

/// One object of a script that is written.
class ScriptFields {
 public:
  nlohmann::json object = nlohmann::json::object();
};

}  // namespace glisson::editing
