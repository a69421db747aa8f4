// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/geometry/closest_point_tree.h"

namespace glisson::ui {

/// The faces of a liver that something touches, painted by hand with a round brush. All in the CT frame,
/// metres.
class AreaPainter {
 public:
  /// @param liver CT frame, metres; a fine one, because what is painted are its vertices
  explicit AreaPainter(TriangleMesh liver);

  /// Begins with a contact as it is: points on the surface, CT frame.
  void begin(const Points& area);
  /// @param p on the surface, or beside it: a ball that does not reach it paints nothing. @param radius
  /// metres; the far side of a thin lobe is not reached. CT frame.
  /// @param add paints, else wipes
  void dab(const Eigen::Vector3d& p, double radius, bool add);

  /// The painted vertices, CT frame.
  Points area() const;
  /// The painted faces, a little above the liver so that they are seen.
  TriangleMesh faces() const;
  /// The brush's border on the liver around a point of it: a closed line, a little above it. CT
  /// frame.
  Points ring(const Eigen::Vector3d& p, double radius) const;

 private:
  TriangleMesh liver_;
  Points normals_;
  ClosestPointTree tree_;
  std::vector<char> painted_;  ///< one a vertex
};

}  // namespace glisson::ui
