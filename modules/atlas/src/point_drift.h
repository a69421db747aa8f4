// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/atlas/shape_model.h"
#include "glisson/core/run_context.h"

/// @file
/// Coherent point drift (Myronenko and Song 2010) of few points with normals. Lengths are in units of the
/// shapes' size here.

namespace glisson::atlas {

/// Points with unit normals, and how the surface bends around them.
struct Oriented {
  Points points, normals;
  Eigen::MatrixXd bends;    ///< one row a point; see bends_of(). No columns: unknown
  Eigen::VectorXd weights;  ///< shares of the surface, their sum is 1
};

/// How far each point stands out of its surroundings along its normal, over the surroundings' radius, for two
/// radii: ridges are above 0, hollows below. @param dense samples of the same surface
Eigen::MatrixXd bends_of(const Oriented& queries, const Oriented& dense);
/// Bends over their deviation on this surface, so that two surfaces compare.
void over_their_deviation(Oriented& shape);

/// Which points of a set lie farthest apart, one after the other, beginning with the one farthest from the
/// centre. @pre count <= points.rows()
std::vector<int> farthest_points(const Points& points, int count);
Points rows_of(const Points& points, const std::vector<int>& rows);

struct Pose {
  Similarity similarity;
  double sigma2 = 0.0;
  double misfit = 0.0;  ///< of distance, normals and bends to the point that is closest so, both ways
  /// The rotation that is expected: livers lie in the CT alike.
  Eigen::Matrix3d held = Eigen::Matrix3d::Identity();
};
/// The similarity that brings `moving` onto `fixed`, from `pose` on.
Pose drift_similarity(const Oriented& moving, const Oriented& fixed, Pose pose, int passes);

/// Pose and coefficients of a model's modes. @param modes 3M x K of `moving`'s points; @param variances of
/// the coefficients. @return the coefficients; `pose` goes on from what it holds.
Eigen::VectorXd drift_modes(const Oriented& moving, const Eigen::MatrixXd& modes,
                            const Eigen::VectorXd& variances, const Oriented& fixed, Pose& pose, int passes);

/// A smooth displacement of all of `mesh`, found at the vertices `chosen`, which bend so. Empty: cancelled.
/// @param width of the Gaussian kernel; stiffness is CPD's lambda.
Cancellable<Points> drift_smooth(const TriangleMesh& mesh, const std::vector<int>& chosen,
                                 const Eigen::MatrixXd& bends, const Oriented& fixed, double width,
                                 double stiffness, double sigma2, int passes, const RunContext& context);

}  // namespace glisson::atlas
