// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "glisson/patient/label_map.h"

namespace glisson {

/// Where the labels of a volume lie from left to right. The voxels are gone through once; whether they look
/// mirrored is then told at once for any meaning of their codes.
class LabelSides {
 public:
  LabelSides() = default;
  explicit LabelSides(const LabelVolume& labels);

  /// As looks_mirrored() of the recoded volume. @param codes what the volume's codes mean (empty: they are
  /// Glisson's).
  bool look_mirrored(const LabelCodes& codes = {}) const;

 private:
  struct Sum {
    Eigen::Vector3d indices = Eigen::Vector3d::Zero();  ///< of all voxels of a code; whole numbers, exact
    long count = 0;
  };
  std::optional<double> mean_left_mm(const std::function<bool(Label)>& wanted) const;

  VolumeGrid grid_;
  std::vector<Sum> sums_;  ///< by code
};

}  // namespace glisson
