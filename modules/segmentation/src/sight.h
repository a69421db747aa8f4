// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tissue.h"

namespace glisson::segmentation {

/// What is seen from a place within 80 mm, to all sides.
class Sight {
 public:
  /// @param liver 1; 2: a second body. @pre both fields outlive it, on one grid.
  Sight(const Field& ct, const Mask& liver);

  /// The part of the view, of 1, that is liver with nothing empty (fat, gas) before it. Within a body that
  /// the liver encloses it is more than one half; beside a flat side of the liver less.
  /// @param from offset of the voxel.
  double share_of_liver(std::size_t from) const { return shares(from)[0]; }

  /// The same of both bodies.
  std::array<double, 2> shares(std::size_t from) const;

 private:
  /// A voxel's width at a time, and the solid angle that it stands for.
  struct Way {
    Eigen::Vector3d step;
    int most_steps;
    double share;
  };

  const Field& ct_;
  const Mask& liver_;
  std::vector<Way> ways_;
};

}  // namespace glisson::segmentation
