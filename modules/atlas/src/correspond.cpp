// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/correspond.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "closest_fit.h"
#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/distance.h"
#include "point_drift.h"
#include "surface_samples.h"

namespace glisson::atlas {
namespace {

constexpr double kGrain = 0.002;  // metres, of the pieces that stand for a surface
/// Edges of cells, of the size: 14 mm for the pose; half of it below kLeastSigma of the drift, so that points
/// feel the surface and not the single samples.
constexpr double kPoseCell = 0.2, kFineCell = 0.5 * kPoseCell;
constexpr int kStartPoints = 140, kStartPasses = 30;
constexpr double kStartCell = 0.4;
constexpr double kStartSigma2 = 0.1;  // of the size squared
constexpr int kDriftPoints = 500;     // of the template
constexpr double kPoseSigma2 = 0.02, kModeSigma2 = 0.01;
constexpr int kPosePasses = 25, kModePasses = 30;
constexpr double kWidth = 0.5, kStiffness = 1.5;  // of the smooth drift: 35 mm on a liver
constexpr int kDriftPasses = 45;
/// Another orientation is taken only if its misfit is below this share of the misfit as the liver stands. A
/// whole liver that lies otherwise gains more than that by turning; a mere half of one that lies right gains
/// less, and must not be turned.
constexpr double kUpright = 0.75;

/// The 24 rotations of a cube, none first.
std::vector<Eigen::Matrix3d> orientations() {
  std::vector<Eigen::Matrix3d> all;
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (const auto& order : orders)
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
      for (int i = 0; i < 3; ++i) turn(i, order[i]) = (signs >> i & 1) != 0 ? -1.0 : 1.0;
      if (turn.determinant() > 0.0) all.push_back(turn);
    }
  return all;
}

/// Points that stand for equal shares of a surface.
Oriented chosen(const Oriented& all, const std::vector<int>& rows) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  return {rows_of(all.points, rows),
          rows_of(all.normals, rows),
          {},
          Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count))};
}

Oriented in_units(const SurfaceSamples& samples, const Eigen::RowVector3d& centre, double size) {
  return {(samples.points.rowwise() - centre) / size, samples.normals, samples.values, samples.weights};
}

/// Held in one orientation; as it stands by default.
Pose start_in(const Oriented& moving, const Oriented& fixed,
              const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
  Pose start;
  start.similarity.rotation = start.held = turn;
  start.sigma2 = kStartSigma2;
  return drift_similarity(moving, fixed, start, kStartPasses);
}

/// The best of the orientations; the one as it stands unless another is clearly better.
Pose best_start(const Oriented& moving, const Oriented& fixed) {
  std::optional<Pose> best;
  double least = 0.0;
  for (const Eigen::Matrix3d& turn : orientations()) {
    const Pose pose = start_in(moving, fixed, turn);
    const double misfit = best ? pose.misfit : kUpright * pose.misfit;
    if (best && misfit >= least) continue;
    best = pose;
    least = misfit;
  }
  return *best;
}

/// All points, from a start that few have found.
Pose refined(const Oriented& moving, const Oriented& fixed, Pose start) {
  start.sigma2 = std::max(start.sigma2, kPoseSigma2);
  return drift_similarity(moving, fixed, start, kPosePasses);
}

Oriented mirrored(Oriented shape, int axis = 0) {
  shape.points.col(axis) *= -1.0;
  shape.normals.col(axis) *= -1.0;
  return shape;
}

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

/// What of the template drifts.
struct Moving {
  Oriented all, some;                                      ///< in units of its size, centred
  std::vector<int> at;                                     ///< vertices that `some` are
  double size = 0.0;                                       ///< metres
  Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();  ///< metres
};
Moving moving_parts(const TriangleMesh& still) {
  Moving parts;
  parts.centre = still.vertices.colwise().mean();
  parts.size = size_of(still.vertices);
  const auto count = static_cast<Eigen::Index>(still.vertex_count());
  parts.all = in_units({still.vertices,
                        vertex_normals(still),
                        Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count)),
                        {}},
                       parts.centre, parts.size);
  parts.at = farthest_points(parts.all.points, std::min(kDriftPoints, still.vertex_count()));
  parts.some = chosen(parts.all, parts.at);
  parts.some.bends = bends_of(
      parts.some,
      in_units(cell_samples(dense_samples(still, kGrain), kFineCell * parts.size), parts.centre, parts.size));
  over_their_deviation(parts.some);
  return parts;
}
struct Laid {
  Pose pose;
  Points vertices;
};

/// From a pose on: the model's modes, then the smooth drift.
Cancellable<Laid> laid_on(const ShapeModel& model, const Triangles& triangles, const Moving& moving,
                          const Oriented& towards, const Oriented& towards_all, Pose pose,
                          const RunContext& context) {
  TriangleMesh now{moving.all.points, triangles};
  if (model.mode_count() > 0) {
    pose.sigma2 = std::max(pose.sigma2, kModeSigma2);
    const Eigen::VectorXd b =
        drift_modes(moving.some, mode_rows(model.modes, moving.at),
                    model.variances / (moving.size * moving.size), towards, pose, kModePasses);
    Eigen::Map<Eigen::VectorXd>(now.vertices.data(), now.vertices.size()) += model.modes * b;
  }
  now.vertices = pose.similarity.apply(now.vertices);
  auto bent = drift_smooth(now, moving.at, moving.some.bends, towards_all, kWidth, kStiffness, pose.sigma2,
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
  // Units of size, centred, on both sides.
  const SurfaceSamples dense = dense_samples(liver, kGrain);
  const Eigen::RowVector3d there = dense.centre();
  const double size_there = dense.size();
  SurfaceSamples fine = cell_samples(dense, kFineCell * size_there);
  fine.values = bends_of(in_units(fine, there, size_there), in_units(fine, there, size_there));
  Oriented towards = in_units(cell_samples(fine, kPoseCell * size_there), there, size_there);
  Oriented towards_all = in_units(fine, there, size_there);
  for (Oriented* one : {&towards, &towards_all}) over_their_deviation(*one);
  const Moving parts = moving_parts({model.mean, triangles});
  const Oriented start_from = chosen(
      parts.some,
      farthest_points(parts.some.points, std::min<int>(kStartPoints, static_cast<int>(parts.at.size()))));
  const Oriented start_to = in_units(cell_samples(dense, kStartCell * size_there), there, size_there);

  Correspondence result;
  Pose pose = best_start(start_from, start_to);
  context.progress(0.1, "atlas.pose");
  if (context.cancelled()) return {};
  pose = refined(parts.some, towards, pose);
  result.misfit = pose.misfit;
  result.mirrored_misfit =
      refined(parts.some, mirrored(towards), best_start(start_from, mirrored(start_to))).misfit;
  result.upright_misfit = refined(parts.some, towards, start_in(start_from, start_to)).misfit;
  result.flipped_misfit = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    result.flipped_misfit = std::min(
        result.flipped_misfit,
        refined(parts.some, mirrored(towards, axis), start_in(start_from, mirrored(start_to, axis))).misfit);
  context.progress(0.3, "atlas.pose");
  auto bent = laid_on(model, triangles, parts, towards, towards_all, pose, context);
  if (!bent) return {};
  pose = bent->pose;
  TriangleMesh now{std::move(bent->vertices), triangles};
  context.progress(0.6, "atlas.drift");
  // Back to metres where the liver lies.
  now.vertices = (size_there * now.vertices).rowwise() + there;
  for (Eigen::Index i = 0; i < fine.points.rows(); ++i)
    fine.points.row(i) = tree.closest(fine.points.row(i).transpose()).point.transpose();
  auto fitted = fit_closest(now, liver, tree, fine, context.part(0.6, 0.95));
  if (!fitted) return {};
  now.vertices = std::move(*fitted);

  result.from_start.scale = pose.similarity.scale * size_there / parts.size;
  result.from_start.rotation = pose.similarity.rotation;
  result.from_start.translation =
      there.transpose() + size_there * pose.similarity.translation -
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
