// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"

namespace glisson::segmentation {

/// Of one label.
struct LabelFigures {
  long voxels = 0;
  double ml = 0.0;
  double mean_hu = 0.0, sd_hu = 0.0;  ///< of the CT's intensities inside
  double longest_diameter_mm = 0.0;   ///< lesions only: the two farthest voxel centres
};

/// Figures of all labels, kept by bricks: after an edit only the bricks that changed are counted again. A
/// value; copies share bricks.
class LabelStatistics {
 public:
  LabelStatistics() = default;
  /// @param image null: intensities count as 0. @pre one grid.
  /// @param former statistics of an earlier state of the labels; used where bricks and image are the same.
  LabelStatistics(const LabelMap& labels, const Image* image, const LabelStatistics* former = nullptr);

  const std::map<Label, LabelFigures>& figures() const { return figures_; }
  /// How many bricks were counted anew (for tests).
  int bricks_counted() const { return bricks_counted_; }

 private:
  struct BrickSums;
  LabelVolume counted_;
  std::shared_ptr<const std::vector<std::int16_t>> voxels_;  ///< that were measured
  std::vector<std::shared_ptr<const BrickSums>> sums_;
  std::map<Label, LabelFigures> figures_;
  int bricks_counted_ = 0;
};

}  // namespace glisson::segmentation
