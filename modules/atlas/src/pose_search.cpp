// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_search.h"

#include <algorithm>
#include <array>
#include <optional>

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
constexpr double kPoseSigma2 = 0.02;
constexpr int kPosePasses = 25;
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

/// Held in one orientation.
Pose start_in(const Oriented& moving, const Oriented& fixed, const Eigen::Matrix3d& turn) {
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

/// How a surface bends is the same in its image.
Oriented image_of(Oriented shape, Axes turned_round) {
  for (int axis = 0; axis < 3; ++axis) {
    if ((turned_round >> axis & 1U) == 0) continue;
    shape.points.col(axis) *= -1.0;
    shape.normals.col(axis) *= -1.0;
  }
  return shape;
}

}  // namespace

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
  parts.few = chosen(parts.some, farthest_points(parts.some.points,
                                                 std::min(kStartPoints, static_cast<int>(parts.at.size()))));
  return parts;
}

Target target_parts(const TriangleMesh& liver) {
  Target parts;
  const SurfaceSamples dense = dense_samples(liver, kGrain);
  parts.centre = dense.centre();
  parts.size = dense.size();
  const auto in_its_units = [&](const SurfaceSamples& samples) {
    return in_units(samples, parts.centre, parts.size);
  };
  parts.fine = cell_samples(dense, kFineCell * parts.size);
  parts.fine.values = bends_of(in_its_units(parts.fine), in_its_units(parts.fine));
  parts.all = in_its_units(parts.fine);
  parts.some = in_its_units(cell_samples(parts.fine, kPoseCell * parts.size));
  for (Oriented* one : {&parts.all, &parts.some}) over_their_deviation(*one);
  parts.few = in_its_units(cell_samples(dense, kStartCell * parts.size));
  return parts;
}

Pose upright_pose(const Moving& moving, const Target& liver, Axes turned_round) {
  const Pose start = start_in(moving.few, image_of(liver.few, turned_round), Eigen::Matrix3d::Identity());
  return refined(moving.some, image_of(liver.some, turned_round), start);
}

Pose free_pose(const Moving& moving, const Target& liver, Axes turned_round) {
  return refined(moving.some, image_of(liver.some, turned_round),
                 best_start(moving.few, image_of(liver.few, turned_round)));
}

}  // namespace glisson::atlas
