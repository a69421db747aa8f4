// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_sides.h"

namespace glisson {

LabelSides::LabelSides(const LabelVolume& labels) : grid_(labels.grid()) {
  const std::vector<Label> dense = labels.dense();
  std::size_t at = 0;
  for (int k = 0; k < grid_.size.z(); ++k)
    for (int j = 0; j < grid_.size.y(); ++j)
      for (int i = 0; i < grid_.size.x(); ++i, ++at) {
        if (dense[at] >= sums_.size()) sums_.resize(std::size_t{dense[at]} + 1);
        Sum& sum = sums_[dense[at]];
        sum.indices += Eigen::Vector3d(i, j, k);
        ++sum.count;
      }
}

/// Mean LPS x of the voxels of the wanted codes, mm.
std::optional<double> LabelSides::mean_left_mm(const std::function<bool(Label)>& wanted) const {
  Sum all;
  for (std::size_t code = 0; code < sums_.size(); ++code) {
    if (!wanted(static_cast<Label>(code))) continue;
    all.indices += sums_[code].indices;
    all.count += sums_[code].count;
  }
  if (all.count == 0) return std::nullopt;
  return 1e3 * grid_.p_in_ct(all.indices / static_cast<double>(all.count)).xyz.x();
}

bool LabelSides::look_mirrored(const LabelCodes& codes) const {
  const auto meaning = [&](Label code) {
    if (codes.empty()) return code;
    const auto known = codes.find(code);
    return known == codes.end() ? structure::kBackground : known->second;
  };
  // The vena cava runs near the midline, the bulk of the liver to the patient's right of it.
  const auto liver = mean_left_mm([&](Label code) { return is_liver_tissue(meaning(code)); });
  const auto cava = mean_left_mm([&](Label code) { return meaning(code) == structure::kVenaCava; });
  return liver && cava && *cava < *liver;
}

}  // namespace glisson
