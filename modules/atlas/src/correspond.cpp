// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/correspond.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "closest_fit.h"
#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/distance.h"
#include "point_drift.h"
#include "pose_search.h"
#include "surface_samples.h"

namespace glisson::atlas {
namespace {

constexpr double kModeSigma2 = 0.01;  // of the size squared
constexpr int kModePasses = 30;
constexpr double kWidth = 0.5, kStiffness = 1.5;  // of the smooth drift: 35 mm on a liver
constexpr int kDriftPasses = 45;
int folded_triangles(const TriangleMesh& mesh, const TriangleMesh& liver, const ClosestPointTree& tree) {
  const Points own = triangle_normals(mesh), theirs = triangle_normals(liver);
  int folded = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d centre = (mesh.vertex(mesh.triangles(t, 0)) + mesh.vertex(mesh.triangles(t, 1)) +
                                    mesh.vertex(mesh.triangles(t, 2))) /
                                   3.0;
    if (own.row(t).dot(theirs.row(tree.closest(centre).triangle)) < 0.0) ++folded;
  }
  return folded;
}

/// Rows x, y, z of the chosen vertices.
Eigen::MatrixXd mode_rows(const Eigen::MatrixXd& modes, const std::vector<int>& vertices) {
  Eigen::MatrixXd rows(3 * static_cast<Eigen::Index>(vertices.size()), modes.cols());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    rows.middleRows(3 * static_cast<Eigen::Index>(i), 3) = modes.middleRows(3L * vertices[i], 3);
  return rows;
}

double turn_of(const Eigen::Matrix3d& rotation) {
  return Eigen::AngleAxisd(rotation).angle() * 180.0 / std::numbers::pi;
}

struct Laid {
  Pose pose;
  Points vertices;
};

/// From a pose on: the model's modes, then the smooth drift.
Cancellable<Laid> laid_on(const ShapeModel& model, const Triangles& triangles, const Moving& moving,
                          const Target& target, Pose pose, const RunContext& context) {
  TriangleMesh now{moving.all.points, triangles};
  if (model.mode_count() > 0) {
    pose.sigma2 = std::max(pose.sigma2, kModeSigma2);
    const Eigen::VectorXd b =
        drift_modes(moving.some, mode_rows(model.modes, moving.at),
                    model.variances / (moving.size * moving.size), target.some, pose, kModePasses);
    Eigen::Map<Eigen::VectorXd>(now.vertices.data(), now.vertices.size()) += model.modes * b;
  }
  now.vertices = pose.similarity.apply(now.vertices);
  auto bent = drift_smooth(now, moving.at, moving.some.bends, target.all, kWidth, kStiffness, pose.sigma2,
                           kDriftPasses, context);
  if (!bent) return {};
  return Laid{pose, std::move(*bent)};
}

}  // namespace

Cancellable<Correspondence> correspond(const ShapeModel& model, const Triangles& triangles,
                                       const TriangleMesh& liver, const RunContext& context) {
  if (liver.triangle_count() == 0)
    throw InputError("", "liver", "has no surface", "Build the model of the liver first");
  const ClosestPointTree tree(liver);
  Target target = target_parts(liver);
  const Moving parts = moving_parts({model.mean, triangles});

  Correspondence result;
  Pose pose = free_pose(parts, target);
  context.progress(0.1, "atlas.pose");
  if (context.cancelled()) return {};
  result.misfit = pose.misfit;
  result.mirrored_misfit = free_pose(parts, target, kLeftRight).misfit;
  result.upright_misfit = upright_pose(parts, target).misfit;
  result.flipped_misfit = std::numeric_limits<double>::infinity();
  for (const Axes pair : {kLeftRight, kFrontBack, kHeadFeet})
    result.flipped_misfit = std::min(result.flipped_misfit, upright_pose(parts, target, pair).misfit);
  context.progress(0.3, "atlas.pose");
  auto bent = laid_on(model, triangles, parts, target, pose, context);
  if (!bent) return {};
  pose = bent->pose;
  TriangleMesh now{std::move(bent->vertices), triangles};
  context.progress(0.6, "atlas.drift");
  // Back to metres where the liver lies.
  now.vertices = (target.size * now.vertices).rowwise() + target.centre;
  SurfaceSamples& fine = target.fine;
  for (Eigen::Index i = 0; i < fine.points.rows(); ++i)
    fine.points.row(i) = tree.closest(fine.points.row(i).transpose()).point.transpose();
  auto fitted = fit_closest(now, liver, tree, fine, context.part(0.6, 0.95));
  if (!fitted) return {};
  now.vertices = std::move(*fitted);

  result.from_start.scale = pose.similarity.scale * target.size / parts.size;
  result.from_start.rotation = pose.similarity.rotation;
  result.from_start.translation =
      target.centre.transpose() + target.size * pose.similarity.translation -
      result.from_start.scale * pose.similarity.rotation * parts.centre.transpose();
  result.turned_deg = turn_of(pose.similarity.rotation);
  const SurfaceDistance apart = surface_distance(now, liver, 4000);
  result.mean_distance = std::max(apart.forward.mean, apart.backward.mean);
  result.max_distance = std::max(apart.forward.maximum, apart.backward.maximum);
  result.folded = folded_triangles(now, liver, tree);
  result.vertices = std::move(now.vertices);
  context.progress(1.0, "atlas.fit");
  return result;
}

}  // namespace glisson::atlas
