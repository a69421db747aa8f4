// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glisson/volume/image.h"

namespace glisson::network {

/// Slices, rows, columns.
using Three = std::array<int, 3>;
using ThreeReal = std::array<double, 3>;

/// A volume's voxels in the order in which a network wants them: axes turned and flipped to the nearest of
/// the directions that are asked for, and voxels of another size between them.
class Oriented {
 public:
  /// @param axes as LabelSheet::axes.
  /// @param spacing_mm as LabelSheet::spacing_mm.
  Oriented(const VolumeGrid& grid, const std::string& axes, const std::vector<double>& spacing_mm);

  /// Of the network's voxels.
  const Three& size() const { return size_; }
  /// The volume's own voxels along slices, rows, columns.
  const Three& volume_size() const { return volume_size_; }
  /// Which of the volume's voxels, as an offset. @pre inside volume_size()
  std::size_t offset(int slice, int row, int column) const {
    return first_ + static_cast<std::size_t>(slice * steps_[0] + row * steps_[1] + column * steps_[2]);
  }
  /// Where the network's voxel lies among the volume's along an axis, and the other way round; held inside.
  double volume_place(int axis, double voxel) const;
  double network_place(int axis, double voxel) const;

 private:
  Three size_{}, volume_size_{};
  std::array<long, 3> steps_{};
  std::size_t first_ = 0;
  ThreeReal scale_{};  ///< the volume's voxels in one of the network's
};

/// A place between two neighbours along an axis.
struct Between {
  int low = 0, high = 0;
  float part = 0.0F;  ///< of `high`
};
/// @pre 0 <= place <= count - 1
Between between(double place, int count);

/// The image's Hounsfield units at a box of the network's voxels, linearly between those of the image; beyond
/// the image its edge goes on. In the network's order.
std::vector<float> sampled(const Image& image, const Oriented& oriented, const Three& first,
                           const Three& size);

}  // namespace glisson::network
