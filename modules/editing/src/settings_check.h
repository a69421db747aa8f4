// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/editing/edit.h"

namespace glisson::editing {

/// The checks of settings that tools share. Each throws an InputError that names the tool as file and the
/// setting as field.
class SettingsCheck {
 public:
  SettingsCheck(std::string tool, const EditableRegion& region) : tool_(std::move(tool)), region_(region) {}

  [[noreturn]] void refuse(const std::string& setting, const std::string& problem,
                           const std::string& remedy) const;
  /// A label that the tool gives to voxels, or takes from them. @param background it may be the background.
  void target(Label label, const std::string& setting, bool background = false) const;
  void length(double metres, const std::string& setting, double most) const;
  /// A voxel axis: 0, 1 or 2.
  void axis(int number, const std::string& setting) const;
  void point(const Eigen::Vector3d& p, const std::string& setting) const;
  /// Of the editable region itself.
  void region() const;

 private:
  std::string tool_;
  const EditableRegion& region_;
};

/// "2.5 mm"
std::string millimetres(double metres);

}  // namespace glisson::editing
