// SPDX-License-Identifier: GPL-3.0-or-later
#include "sight.h"

#include <algorithm>
#include <cmath>

namespace glisson::segmentation {
namespace {

constexpr double kSight = 80.0;  // mm

}  // namespace

Sight::Sight(const Field& ct, const Mask& liver) : ct_(ct), liver_(liver) {
  // To the surface of the cube of five voxels around one.
  double sum = 0.0;
  for (int k = -2; k <= 2; ++k)
    for (int j = -2; j <= 2; ++j)
      for (int i = -2; i <= 2; ++i) {
        if (std::max({std::abs(i), std::abs(j), std::abs(k)}) < 2) continue;
        const Eigen::Vector3d step = 0.5 * Eigen::Vector3d(i, j, k);
        const double mm = step.cwiseProduct(ct.spacing_mm).norm();
        ways_.push_back({step, static_cast<int>(kSight / mm), 1.0 / (mm * mm * mm)});
        sum += ways_.back().share;
      }
  for (Way& way : ways_) way.share /= sum;
}

std::array<double, 2> Sight::shares(std::size_t from) const {
  const Eigen::Vector3d start = ct_.voxel_at(from).cast<double>();
  std::array<double, 2> shares{};
  for (const Way& way : ways_)
    for (int n = 1; n <= way.most_steps; ++n) {
      const Eigen::Vector3i v = (start + n * way.step).array().round().matrix().cast<int>();
      if (!ct_.contains(v) || ct_.values[ct_.offset(v)] < kEmptyTissue) break;
      const std::uint8_t body = liver_.voxels[ct_.offset(v)];
      if (body == 0) continue;
      shares[body - 1U] += way.share;
      break;
    }
  return shares;
}

}  // namespace glisson::segmentation
