// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <memory>
#include <vector>

#include "glisson/geometry/mesh.h"

class vtkRenderer;

namespace glisson::scene {

/// A structure that is proposed: CT frame, metres.
struct ProposalMark {
  Points points;                             ///< ordered
  std::vector<Eigen::Matrix3d> covariances;  ///< one a point, m2
  Points area;                               ///< of a contact; may be empty
  TriangleMesh faces;                        ///< a piece of surface, or a liver of its own; may be empty
  QColor colour;
  bool is_line = false;     ///< points along a course; else single ones
  bool is_chosen = false;   ///< with its ellipsoids, and thicker
  double ellipsoid2 = 0.0;  ///< squared Mahalanobis distance of the ellipsoids' surface
};

/// The ellipsoid |p - centre| = sqrt(distance2) in the covariance's measure, normals outward, in the centre's
/// frame.
TriangleMesh ellipsoid(const Eigen::Vector3d& centre, const Eigen::Matrix3d& covariance, double distance2);

/// Proposals as VTK actors in a renderer: balls or tubes, areas as dots, of the chosen one the ellipsoids,
/// translucent. Not thread-safe.
class ProposalActors {
 public:
  /// @param renderer is kept.
  explicit ProposalActors(vtkRenderer& renderer);
  ~ProposalActors();
  ProposalActors(const ProposalActors&) = delete;
  ProposalActors& operator=(const ProposalActors&) = delete;

  /// Replaces what is shown.
  void show(const std::vector<ProposalMark>& marks);
  int actor_count() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::scene
