// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>

#include "glisson/geometry/mesh.h"
#include "glisson/ui/scene/slice_picture.h"

namespace glisson::scene {

/// A place that is known with a covariance, marked over the slices.
struct EllipsoidMark {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();                      ///< CT frame, metres
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity() * 1e-6;  ///< m2
  double distance2 = 0.0;  ///< squared Mahalanobis distance of the ellipsoid's surface; 0: the place alone
  QColor colour;
  bool operator==(const EllipsoidMark&) const = default;
};

/// The closed line in which a slice cuts the mark's ellipsoid: CT frame, metres. No row: it does not.
/// @pre a positive definite covariance
Points cut(const EllipsoidMark& mark, const SliceGeometry& slice);

}  // namespace glisson::scene
