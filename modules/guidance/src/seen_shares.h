// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/closest_point_tree.h"

namespace glisson::guidance {

/// How much of each part of a surface stereo sees while nothing hides it. Plain tissue shows little, so that
/// little of it seen is no cover; and what is in sight changes with the scope.
class SeenShares {
 public:
  explicit SeenShares(int triangles) : parts_(static_cast<std::size_t>(triangles)) {}

  /// @param hits where rays meet the surface; triangle < 0: they miss it. @param is_seen one a hit.
  void learn(const std::vector<ClosestPoint>& hits, const std::vector<char>& is_seen);
  /// @return the share of what is expected of the places in sight that is not seen, in [0, 1]; 0: too few of
  ///   them have been learnt.
  double missing(const std::vector<ClosestPoint>& hits, const std::vector<char>& is_seen) const;

 private:
  struct Part {
    int looks = 0, seen = 0;  ///< rays
  };
  std::vector<Part> parts_;  ///< one a triangle
};

}  // namespace glisson::guidance
