// SPDX-License-Identifier: GPL-3.0-or-later
#include "metal.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/volume/axes.h"

namespace glisson::segmentation {
namespace {

constexpr double kMetal = 2500.0;  // HU: no bone or stone is so dense
constexpr double kThing = 25.0;    // mm^2 in a slice: a clip for vessels is less
constexpr double kReach = 20.0;    // mm above and below the liver that was found: it may end at the streaks

}  // namespace

std::optional<std::string> metal_note(const Image& image, const LabelVolume& labels) {
  if (image.modality != Modality::ct) return {};
  const std::vector<std::uint8_t> liver = labels.mask(is_liver_tissue);
  const VolumeGrid& grid = image.grid;
  const int axis = axis_along(grid, 2);
  std::vector<long> metal(static_cast<std::size_t>(grid.size[axis]), 0);
  int first = grid.size[axis], last = -1;
  std::size_t at = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i, ++at) {
        const int slice = Eigen::Vector3i(i, j, k)[axis];
        metal[static_cast<std::size_t>(slice)] += (*image.voxels)[at] > kMetal;
        if (liver[at] != 0) first = std::min(first, slice), last = std::max(last, slice);
      }
  const double spacing = grid.spacing_mm[axis], area = grid.voxel_volume_mm3() / spacing;
  long slices = 0;
  for (int n = 0; n < grid.size[axis]; ++n)
    slices += spacing * (first - n) <= kReach && spacing * (n - last) <= kReach &&
              area * static_cast<double>(metal[static_cast<std::size_t>(n)]) >= kThing;
  if (last < 0 || slices == 0) return {};
  return "image.metal " + std::to_string(slices);
}

}  // namespace glisson::segmentation
