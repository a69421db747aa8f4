// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <random>

#include "glisson/geometry/mesh.h"
#include "glisson/volume/label_volume.h"
#include "glisson/volume/morphology.h"

namespace glisson::test {

/// A person who knows the anatomy and clicks with a shaky hand. Looks at a label map, writes clicks; what is
/// tested sees the clicks only.
class Operator {
 public:
  Operator(VolumeGrid grid, unsigned seed, double noise_mm)
      : grid_(std::move(grid)), random_(seed), noise_(0.0, noise_mm) {}

  /// `count` clicks spread over the part of `mask` that is at least `depth_mm` deep, or over its deepest part
  /// when none is.
  Points click(const std::vector<std::uint8_t>& mask, int count, double depth_mm) {
    const VoxelBox box = bounding_box(grid_.size, grid_.spacing_mm, mask, 3.0);
    if (box.empty()) return Points(0, 3);
    Mask outside = crop(grid_.size, grid_.spacing_mm, mask, box);
    for (auto& v : outside.voxels) v = v == 0 ? 1 : 0;
    const std::vector<float> depth2 = squared_distance_mm2(outside);
    const double deepest = std::sqrt(*std::max_element(depth2.begin(), depth2.end()));
    const double least = std::min(depth_mm, 0.8 * deepest);
    std::vector<Eigen::Vector3d> places;
    for (int k = 0; k < outside.size.z(); ++k)
      for (int j = 0; j < outside.size.y(); ++j)
        for (int i = 0; i < outside.size.x(); ++i)
          if (depth2[outside.offset(i, j, k)] >= least * least)
            places.push_back((box.low + Eigen::Vector3i(i, j, k)).cast<double>());
    std::vector<Eigen::Vector3d> clicks;
    while (static_cast<int>(clicks.size()) < count) clicks.push_back(next_of(places, clicks));
    Points points(count, 3);
    for (int n = 0; n < count; ++n) {
      Eigen::Vector3d p = grid_.p_in_ct(clicks[static_cast<std::size_t>(n)]).xyz;
      for (int axis = 0; axis < 3; ++axis) p[axis] += 1e-3 * noise_(random_);
      // Nobody clicks beside the picture.
      const Eigen::Vector3d last = (grid_.size - Eigen::Vector3i::Ones()).cast<double>();
      const Eigen::Vector3d index = grid_.index_of(Point<CtFrame>(p)).cwiseMax(0.0).cwiseMin(last);
      points.row(n) = grid_.p_in_ct(index).xyz.transpose();
    }
    return points;
  }

 private:
  /// The farthest of some random places from the clicks so far.
  Eigen::Vector3d next_of(const std::vector<Eigen::Vector3d>& places,
                          const std::vector<Eigen::Vector3d>& clicks) {
    Eigen::Vector3d best = places[random_() % places.size()];
    double farthest = -1.0;
    for (int trial = 0; trial < 300 && !clicks.empty(); ++trial) {
      const Eigen::Vector3d& place = places[random_() % places.size()];
      double near = 1e30;
      for (const Eigen::Vector3d& click : clicks)
        near = std::min(near, (place - click).cwiseProduct(grid_.spacing_mm).norm());
      if (near > farthest) farthest = near, best = place;
    }
    return best;
  }

  VolumeGrid grid_;
  std::mt19937 random_;
  std::normal_distribution<double> noise_;
};

}  // namespace glisson::test
