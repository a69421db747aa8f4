// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace glisson::stereo {

/// What OpenCV's FileStorage writes of a calibration, YAML or JSON: scalars and matrices by name, at the top.
/// Other values are passed over. A strict reader of our own, because OpenCV's trusts what it reads.
class OpenCvText {
 public:
  /// @param name stands in messages. @throws InputError neither YAML nor JSON of this shape; a name stands
  /// twice.
  OpenCvText(std::string_view content, std::string name);

  bool has(const std::string& key) const { return values_.contains(key); }
  /// Empty: there is none, or it is no scalar.
  std::optional<std::string> scalar(const std::string& key) const;
  /// @throws InputError naming the key: it is missing or no matrix of at most 16 x 16 finite numbers.
  Eigen::MatrixXd matrix(const std::string& key) const;

 private:
  struct Value {
    bool is_matrix = false, is_scalar = false;
    std::string text;                           ///< of a scalar
    std::map<std::string, std::string> fields;  ///< of a matrix: rows, cols, dt, data
  };
  void read_yaml(std::string_view content);
  void read_json(std::string_view content);
  void add(const std::string& key, Value value);

  std::string name_;
  std::map<std::string, Value> values_;
};

}  // namespace glisson::stereo
