// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/network/label_sheet.h"
#include "oriented.h"

namespace glisson::network {

/// Makes labels on the volume's own voxels of scores on the network's, which come slice by slice: scores are
/// taken linearly between the network's voxels first, and decide then.
class Painter {
 public:
  Painter(const Oriented& oriented, const LabelSheet& sheet);
  /// The scores of the next slice, channel by channel.
  void add(std::vector<float> scores);
  /// Each voxel's label, in the volume's order; lesions are all LabelSheet::kLesions. @pre all slices came
  std::vector<Label> take() { return std::move(labels_); }

 private:
  void paint(int slice, const std::vector<float>& low, const std::vector<float>& high, float part);
  Label decided(const std::vector<float>& scores) const;

  const Oriented& oriented_;
  const LabelSheet& sheet_;
  std::vector<Between> rows_, columns_;
  std::vector<float> former_;
  int network_slice_ = -1, next_ = 0;  ///< of the network's that came last, of the volume's that comes next
  std::vector<Label> labels_;
};

}  // namespace glisson::network
