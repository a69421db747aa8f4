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
constexpr double kBone = 300.0;    // HU: where enhanced organs end
constexpr double kThing = 25.0;    // mm^2 in a slice: a clip for vessels is less
constexpr double kReach = 20.0;    // mm above and below the liver that was found: it may end at the streaks

/// How many slices hold kThing of what is as bright as `least` (HU) in the liver's slices and kReach beyond.
long slices_with(double least, const Image& image, const LabelVolume& labels) {
  const std::vector<std::uint8_t> liver = labels.mask(is_liver_tissue);
  const VolumeGrid& grid = image.grid;
  const int axis = axis_along(grid, 2);
  std::vector<long> bright(static_cast<std::size_t>(grid.size[axis]), 0);
  int first = grid.size[axis], last = -1;
  std::size_t at = 0;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i, ++at) {
        const int slice = Eigen::Vector3i(i, j, k)[axis];
        bright[static_cast<std::size_t>(slice)] += (*image.voxels)[at] >= least;
        if (liver[at] != 0) first = std::min(first, slice), last = std::max(last, slice);
      }
  if (last < 0) return 0;
  const double spacing = grid.spacing_mm[axis], area = grid.voxel_volume_mm3() / spacing;
  long slices = 0;
  for (int n = 0; n < grid.size[axis]; ++n)
    slices += spacing * (first - n) <= kReach && spacing * (n - last) <= kReach &&
              area * static_cast<double>(bright[static_cast<std::size_t>(n)]) >= kThing;
  return slices;
}

}  // namespace

std::optional<std::string> metal_note(const Image& image, const LabelVolume& labels) {
  if (image.modality != Modality::ct) return {};
  const double most = *std::ranges::max_element(*image.voxels);
  const double least = std::min(most, kMetal + 1.0);
  if (least < kBone) return {};
  const long slices = slices_with(least, image, labels);
  if (slices == 0) return {};
  if (most > kMetal) return "image.metal " + std::to_string(slices);
  return "image.clipped " + std::to_string(static_cast<int>(most)) + " " + std::to_string(slices);
}

}  // namespace glisson::segmentation
