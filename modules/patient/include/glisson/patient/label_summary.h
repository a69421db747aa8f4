// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "glisson/patient/label_map.h"

namespace glisson {

/// How many voxels each code of a label volume has, and where they lie. The voxels are gone through once;
/// what is asked of them is then told at once, for any meaning of the codes. In all that follows `codes` are
/// what the volume's codes mean; empty: they are Glisson's.
class LabelSummary {
 public:
  LabelSummary() = default;
  explicit LabelSummary(const LabelVolume& labels);

  /// The labels that have voxels, without the background.
  std::set<Label> labels(const LabelCodes& codes = {}) const;
  /// The volume of a code of the file's, ml.
  double ml(Label code) const;
  /// As looks_mirrored() of the recoded volume.
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

/// @param name of the file, for the message. @throws InputError the labels look mirrored.
void require_not_mirrored(const LabelSummary& summary, const LabelCodes& codes, const std::string& name);

/// As recode() of label_map.h; whether the labels look mirrored is left to the caller.
/// @param summary of the file's voxels.
LabelMap recode(const LabelFile& file, const LabelSummary& summary, const LabelCodes& codes,
                const std::string& name);

}  // namespace glisson
