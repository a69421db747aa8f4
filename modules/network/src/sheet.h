// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace glisson::network {

/// Where the sheet of a network lies: MODEL.json beside MODEL.onnx.
std::filesystem::path sheet_of(const std::filesystem::path& network);

/// A JSON object, field by field; every complaint names the file, the field and what to write instead.
class Sheet {
 public:
  /// @throws FileError when it cannot be read, InputError when it is missing, no JSON or no object.
  explicit Sheet(const std::filesystem::path& path);

  bool has(const char* field) const { return document_.contains(field); }
  /// Each throws InputError when the field is there and of another kind, or out of range.
  std::optional<double> number(const char* field, double low, double high);
  std::optional<std::vector<double>> numbers(const char* field, double low, double high);
  std::optional<std::string> text(const char* field);
  std::optional<std::vector<std::string>> texts(const char* field);
  /// @throws InputError for a field that nobody has asked for: a slip of the pen would pass unnoticed.
  void no_other_fields() const;
  [[noreturn]] void refuse(const std::string& field, const std::string& problem,
                           const std::string& remedy) const;

 private:
  const nlohmann::json* find(const char* field);

  std::string path_;
  nlohmann::json document_;
  std::set<std::string> known_;
};

}  // namespace glisson::network
