// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "glisson/geometry/mesh.h"

namespace glisson::guidance {

/// Where fresh stereo has seen the followed tissue, all looks joined in the shape that was registered: there
/// a place of the tissue is the same in every frame, however organ and scope have moved since. What stereo
/// errs differs from look to look and averages out; what passes before the organ does not stay with its
/// tissue, and is left out.
class TissueMap {
 public:
  /// One fresh surface. @param places in the registered shape, metres.
  void add(const std::vector<Eigen::Vector3d>& places);
  /// Fresh surfaces so far.
  int looks() const { return looks_; }
  /// A place a cell of 4 mm that three looks and more have seen, N x 3, metres, in an order that repeats.
  Points places() const;
  void clear();

 private:
  struct Cell {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    int points = 0, looks = 0, last_look = 0;
  };
  std::unordered_map<std::uint64_t, Cell> cells_;
  int looks_ = 0;
};

}  // namespace glisson::guidance
