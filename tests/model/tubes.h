// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "skeleton.h"

/// @file
/// Vessels whose centrelines and radii are known in closed form, as voxels.

namespace glisson::test {

using model::VesselVoxels;

/// A centreline as a function of [0, 1], millimetres.
struct Tube {
  std::function<Eigen::Vector3d(double)> line;
  double radius;
};

inline Tube straight(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  return {[=](double t) -> Eigen::Vector3d { return from + t * (to - from); }, radius};
}

inline std::vector<Eigen::Vector3d> sampled(const Tube& tube) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 600; ++i) points.push_back(tube.line(i / 600.0));
  return points;
}

inline double length_of(const std::vector<Eigen::Vector3d>& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

inline double distance_to(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& p) {
  double least = 1e9;
  for (const auto& q : line) least = std::min(least, (p - q).norm());
  return least;
}

/// Voxels within the tubes. `jitter` turns that share of the voxels in the outermost half millimetre around.
inline Mask voxels_of(const std::vector<Tube>& tubes, const Eigen::Vector3d& extent_mm,
                      const Eigen::Vector3d& spacing, double jitter = 0.0) {
  Mask mask((extent_mm.cwiseQuotient(spacing)).array().ceil().cast<int>() + 1, spacing);
  std::vector<double> depth(mask.voxels.size(), -1e9);
  for (const Tube& tube : tubes)
    for (const Eigen::Vector3d& centre : sampled(tube)) {
      const Eigen::Array3i
          low = ((centre.array() - tube.radius - 1.0) / spacing.array()).floor().cast<int>().max(1),
          high = ((centre.array() + tube.radius + 1.0) / spacing.array())
                     .ceil()
                     .cast<int>()
                     .min(mask.size.array() - 2);
      for (int k = low.z(); k <= high.z(); ++k)
        for (int j = low.y(); j <= high.y(); ++j)
          for (int i = low.x(); i <= high.x(); ++i) {
            double& at = depth[mask.offset(i, j, k)];
            at = std::max(at, tube.radius - (Eigen::Vector3d(i, j, k).cwiseProduct(spacing) - centre).norm());
          }
    }
  std::mt19937 random(3);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const bool turned = std::abs(depth[i]) < 0.5 && static_cast<double>(random() % 1000) < 1000 * jitter;
    mask.voxels[i] = (depth[i] > 0.0) != turned;
  }
  return mask;
}

inline int voxel_at(const VesselVoxels& vessel, const Eigen::Vector3d& p_mm) {
  int best = -1;
  for (std::size_t i = 0; i < vessel.mask.voxels.size(); ++i)
    if (vessel.mask.voxels[i] != 0 && (best < 0 || (vessel.position_mm(static_cast<int>(i)) - p_mm).norm() <
                                                       (vessel.position_mm(best) - p_mm).norm()))
      best = static_cast<int>(i);
  return best;
}

inline VolumeGrid grid_of(const Mask& mask) {
  VolumeGrid grid;
  grid.size = mask.size;
  grid.spacing_mm = mask.spacing_mm;
  grid.origin_mm << 10, -20, 30;
  return grid;
}

}  // namespace glisson::test
