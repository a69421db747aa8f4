// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/mesh.h"
#include "glisson/geometry/sharpness.h"

namespace glisson::model {

/// The anterior margin of one surface, sought more than once: what no cut changes is worked out once.
class MarginSearch {
 public:
  /// Both as detect_anterior_margin() has them. @param surface has to outlive this. @pre it has triangles
  MarginSearch(const TriangleMesh& surface, const Eigen::Vector3d& inferior_anterior);

  /// As detect_anterior_margin() says.
  Points margin(const TriangleMesh& cut) const;

 private:
  const TriangleMesh& surface_;
  TriangleMesh mesh_;  ///< finer
  Sharpness sharpness_;
  std::vector<std::vector<int>> neighbours_;
  Eigen::Vector3d wanted_;     ///< unit vector, or zero
  std::vector<double> sharp_;  ///< of the vertices, not above 0 where they face the wrong way
};

}  // namespace glisson::model
