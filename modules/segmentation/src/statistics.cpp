// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "glisson/core/error.h"
#include "glisson/segmentation/lesion_size.h"

namespace glisson::segmentation {

/// What one brick adds to each label in it. Whole numbers, so that sums do not depend on their order.
struct LabelStatistics::BrickSums {
  struct Sum {
    Label label = 0;
    std::int64_t voxels = 0, intensity = 0, squares = 0;
  };
  std::vector<Sum> sums;
};

namespace {

/// Calls voxel(offset in the brick, offset in the image) for the voxels of a brick that lie in the volume.
template <class Voxel>
void for_each_voxel(const LabelVolume& labels, std::size_t number, Voxel&& voxel) {
  constexpr int kSide = LabelVolume::kSide;
  const VolumeGrid& grid = labels.grid();
  const Eigen::Vector3i low = kSide * labels.brick_place(number);
  const Eigen::Vector3i size = (grid.size - low).cwiseMin(kSide);
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j) {
      const auto in_brick = static_cast<std::size_t>(kSide * (j + kSide * k));
      const auto in_image = static_cast<std::size_t>(grid.offset(low + Eigen::Vector3i(0, j, k)));
      for (int i = 0; i < size.x(); ++i)
        voxel(in_brick + static_cast<std::size_t>(i), in_image + static_cast<std::size_t>(i));
    }
}

}  // namespace

LabelStatistics::LabelStatistics(const LabelMap& labels, const Image* image, const LabelStatistics* former)
    : counted_(labels.voxels), voxels_(image != nullptr ? image->voxels : nullptr) {
  const VolumeGrid& grid = counted_.grid();
  require(voxels_ == nullptr || static_cast<long>(voxels_->size()) == grid.voxel_count(),
          "labels and the image that they are measured on have one grid");
  const bool usable =
      former != nullptr && former->voxels_ == voxels_ && former->counted_.grid().same_as(grid);
  sums_.resize(counted_.brick_count());
  std::map<Label, BrickSums::Sum> totals;
  std::set<Label> touched;  // in a brick that was counted anew
  for (std::size_t n = 0; n < sums_.size(); ++n) {
    const auto& brick = counted_.brick(n);
    if (!brick) continue;
    if (usable && former->sums_[n] && former->counted_.brick(n) == brick) {
      sums_[n] = former->sums_[n];
    } else {
      ++bricks_counted_;
      std::map<Label, BrickSums::Sum> here;
      Label last = 0;
      BrickSums::Sum* sum = nullptr;
      for_each_voxel(counted_, n, [&](std::size_t in_brick, std::size_t in_image) {
        const Label label = (*brick)[in_brick];
        if (label == 0) return;
        if (sum == nullptr || label != last) {
          sum = &here[label];
          sum->label = last = label;
        }
        const std::int64_t value = voxels_ ? (*voxels_)[in_image] : 0;
        ++sum->voxels;
        sum->intensity += value;
        sum->squares += value * value;
      });
      auto sums = std::make_shared<BrickSums>();
      for (const auto& [label, one] : here) {
        sums->sums.push_back(one);
        touched.insert(label);
      }
      sums_[n] = std::move(sums);
    }
    for (const BrickSums::Sum& one : sums_[n]->sums) {
      BrickSums::Sum& total = totals[one.label];
      total.voxels += one.voxels;
      total.intensity += one.intensity;
      total.squares += one.squares;
    }
  }
  for (const auto& [label, total] : totals) {
    LabelFigures& figures = figures_[label];
    const auto count = static_cast<double>(total.voxels);
    figures.voxels = total.voxels;
    figures.ml = 1e-3 * grid.voxel_volume_mm3() * count;
    figures.mean_hu = static_cast<double>(total.intensity) / count;
    figures.sd_hu = std::sqrt(
        std::max(0.0, static_cast<double>(total.squares) / count - figures.mean_hu * figures.mean_hu));
    if (!is_lesion(label)) continue;
    const auto before = usable ? former->figures_.find(label) : figures_.end();
    const bool known = usable && before != former->figures_.end() &&
                       before->second.voxels == figures.voxels && !touched.contains(label);
    figures.longest_diameter_mm =
        known ? before->second.longest_diameter_mm : longest_diameter(counted_, label).mm;
  }
}

}  // namespace glisson::segmentation
