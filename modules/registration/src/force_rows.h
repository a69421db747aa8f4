// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/fem/elastic_body.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"

namespace glisson::registration {

/// Neighbouring margin points share the model's error: independent information in a reference spacing's
/// point.
inline constexpr double kMarginInformation = 0.2;

/// Adds to a row how a carried point moves along a direction with nodal vectors, one a column.
void add_along(const Carrier& carrier, const Eigen::Vector3d& direction, const fem::NodalColumns& columns,
               Eigen::Ref<Eigen::RowVectorXd> row);

/// What the cloud says of where the organ is: one number a row, how far the model is from a point of the
/// cloud along one direction.
struct ForceRows {
  std::vector<Carrier> carriers;   ///< what moves the model's point
  Points points;                   ///< on the model
  Points directions;               ///< unit
  Eigen::VectorXd gap;             ///< from the model's point to the cloud's, m
  Eigen::VectorXd sigma;           ///< standard deviation, m; larger for what lies apart (Cauchy)
  std::vector<int> seen_in;        ///< which look
  Eigen::Index surface_count = 0;  ///< rows of the surface, one a point; they come first
  double outlier_share = 0.0;      ///< of these, that weigh less than a half

  Eigen::Index size() const { return gap.size(); }
  /// How each row's model point moves along the row's direction with nodal vectors. Shape: size() x columns.
  Eigen::MatrixXd along(const fem::NodalColumns& columns) const;
};

/// How far a point of the cloud may lie from the model, besides what the cloud itself says of the point
/// (PreparedCloud::deviation). That counts instead where it is more than `sigma`; with `information`, where
/// `sigma` is an error that neighbours share, it is added to it, since neighbours do not share it.
struct RowNoise {
  double sigma = 3e-3;  ///< of surface points across the surface, m
  double half = 6e-3;   ///< distance at which a surface point's weight is a half, m
  /// Independent information in what the reference density's one surface point stands for
  /// (ShapeFitOptions); empty: each point of the cloud is independent, whatever it stands for.
  std::optional<double> information;
};

/// Every point counts along the surface's normal alone, whatever its label and the distance; after these,
/// where the model has the landmark, margin points and the notch's centroid in all directions, restricted to
/// their parts.
/// @param surface where the model is now, in the cloud's frame.
ForceRows find_rows(const PreparedCloud& cloud, const MovingSurface& surface, const RowNoise& noise);

}  // namespace glisson::registration
