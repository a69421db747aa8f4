// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "field.h"

namespace glisson::segmentation {

/// Values of a field's grid at a place, voxels; constant beyond its edge.
double trilinear(const Field& field, const std::vector<float>& values, const Eigen::Vector3d& at);

/// Directions spread evenly over the sphere (a spiral of golden angles), and of each its nearest ones.
class Rays {
 public:
  static constexpr std::size_t kCount = 600, kNeighbours = 6;
  static constexpr double kStep = 0.75;  ///< mm: radii are whole steps
  Rays();
  const Eigen::Vector3d& way(std::size_t ray) const { return ways_[ray]; }
  const std::array<std::size_t, kNeighbours>& near(std::size_t ray) const { return near_[ray]; }

 private:
  std::vector<Eigen::Vector3d> ways_;
  std::vector<std::array<std::size_t, kNeighbours>> near_;
};
const Rays& rays();

/// A body each of whose points is seen from its middle.
struct Star {
  static constexpr double kDrawnShare = 0.15;  ///< of a drawn diameter: the deviation of a body's radius
  Eigen::Vector3d middle;                      ///< voxels of a field, real-valued
  std::vector<int> radii;                      ///< one for each ray, in steps; empty: none
  std::vector<double> beyond_mm = {};          ///< of each ray, what its boundary lies off its step; empty: 0
  double radius_mm(std::size_t ray) const {
    return Rays::kStep * radii[ray] + (beyond_mm.empty() ? 0.0 : beyond_mm[ray]);
  }
  double mean_radius_mm() const;
  /// Towards a place: that of the ray nearest to it.
  double radius_towards_mm(const Eigen::Vector3d& way) const;
};

struct StarOptions {
  double reach_mm = 65.0;          ///< the longest radius
  double diameter_mm = 0.0;        ///< of the body, about; 0: not known
  double against = -3.0;           ///< evidence beyond the field
  double lost = 8.0;               ///< evidence against, in a row, behind which a ray sees nothing more
  double stiff = 4.0, soft = 0.4;  ///< 1 / mm^2: how rays hold their neighbours, at first and at last
};

/// The radii that gather most evidence (per mm, of either sign, summed along each ray) less
/// w (r - mean of the neighbours)^2 for each ray, w falling from stiff to soft: graduated non-convexity
/// (Blake and Zisserman 1987) by coordinate descent. With a diameter, less 2 (r - d / 2)^2 / (0.15 d)^2, too.
/// The middle moves to the body's centroid and all is done again, `moves` times, as long as `inside` lies in
/// the body.
/// @param evidence of each voxel of `field`. @param from its radii may be empty.
Star grow_star(const Field& field, const std::vector<float>& evidence, Star from,
               const Eigen::Vector3d& inside, int moves, const StarOptions& options);

/// Evidence within, mean over the rays, mm.
double gathered(const Field& field, const std::vector<float>& evidence, const Star& star,
                const StarOptions& options);

/// mm along the rays, negative inside, within `band_mm` of the boundary.
Field distance_to(const Star& star, const Field& field, double band_mm);

}  // namespace glisson::segmentation
