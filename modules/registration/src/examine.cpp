// SPDX-License-Identifier: GPL-3.0-or-later
#include "examine.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "glisson/core/statistics.h"
#include "glisson/registration/rivals.h"

namespace glisson::registration {
namespace {

constexpr int kNeighbours = 30;
constexpr double kBehind = 10e-3;  ///< m
constexpr double kAgainst = 0.34;  ///< cosine of 70 degrees

/// Of one point: rms about a paraboloid through its neighbours, freedom taken into account.
double roughness_at(const Points& points, const std::vector<int>& neighbours, Eigen::Index i) {
  constexpr int kTerms = 6;
  const auto n = static_cast<Eigen::Index>(neighbours.size()) + 1;
  Points near(n, 3);
  near.row(0) = points.row(i);
  for (Eigen::Index k = 1; k < n; ++k) near.row(k) = points.row(neighbours[static_cast<std::size_t>(k - 1)]);
  near.rowwise() -= near.colwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Eigen::Matrix3d(near.transpose() * near));
  const Points local = near * eigen.eigenvectors();  // height first, then across and along
  const double scale = std::max(1e-9, local.rightCols<2>().cwiseAbs().maxCoeff());
  Eigen::MatrixXd terms(n, kTerms);
  const Eigen::VectorXd u = local.col(1) / scale, v = local.col(2) / scale;
  terms << Eigen::VectorXd::Ones(n), u, v, u.cwiseAbs2(), u.cwiseProduct(v), v.cwiseAbs2();
  const Eigen::VectorXd height = local.col(0);
  const Eigen::VectorXd left = height - terms * terms.colPivHouseholderQr().solve(height);
  return std::sqrt(left.squaredNorm() / static_cast<double>(n - kTerms));
}

double hidden_share(const MovingSurface& surface, const PreparedCloud& cloud, const RunContext& context) {
  int hidden = 0;
  for (int i = 0; i < cloud.cloud.size() && !context.cancelled(); ++i) {
    const Eigen::Vector3d eye = cloud.cloud.eye(i), ray = cloud.cloud.points.row(i).transpose() - eye;
    const double length = ray.norm();
    if (length > kBehind && surface.first_hit(eye, ray / length, 0.0, length - kBehind).triangle >= 0)
      ++hidden;
  }
  return hidden / static_cast<double>(cloud.cloud.size());
}

/// @param in_cameras_frame without it estimated normals have no side that they face.
void look_at_pairs(const MovingSurface& surface, const PreparedCloud& cloud, bool in_cameras_frame,
                   Findings& findings) {
  const bool has_normals = cloud.cloud.normals.rows() > 0;
  const Points normals = has_normals ? cloud.cloud.normals : estimate_normals(cloud);
  int surface_points = 0, turned = 0, margin_points = 0;
  double margin = 0.0;
  for (const Pair& pair : find_pairs(cloud, surface, {})) {
    switch (pair.feature) {
      case Feature::surface:
        ++surface_points;
        turned += pair.normal.dot(normals.row(pair.point)) < kAgainst;
        break;
      case Feature::anterior_margin:
        if (!surface.has(pair.feature)) break;
        ++margin_points;
        margin += landmark_share(pair.feature, pair.deviation) * pair.gap.squaredNorm();
        break;
      case Feature::umbilical_notch:
        if (surface.has(pair.feature))
          findings.notch_off = std::sqrt(landmark_share(pair.feature, pair.deviation)) * pair.gap.norm();
        break;
    }
  }
  if (surface_points > 0 && (has_normals || in_cameras_frame))
    findings.turned = turned / static_cast<double>(surface_points);
  if (margin_points >= 5) findings.margin_off = std::sqrt(margin / margin_points);
}

}  // namespace

double roughness_of(const PreparedCloud& cloud, const RunContext& context) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < cloud.cloud.points.rows(); ++i) {
    if (context.cancelled()) return 0.0;
    if (cloud.neighbours[static_cast<std::size_t>(i)].size() >= 8)
      values.push_back(roughness_at(cloud.cloud.points, cloud.neighbours[static_cast<std::size_t>(i)], i));
  }
  return values.empty() ? 0.0 : upper_median(std::move(values));
}

namespace {

/// m3, of the mesh with its nodes there; what is turned inside out counts negative.
double volume_of(const Points& nodes, TetMesh mesh) {
  mesh.vertices = nodes;
  return tetrahedron_volumes(mesh).sum();
}

}  // namespace

LabelledCloud mirrored(const LabelledCloud& cloud) {
  LabelledCloud image = cloud;
  image.points.col(0) *= -1.0;
  if (image.normals.rows() > 0) image.normals.col(0) *= -1.0;
  if (image.eyes.rows() > 0) image.eyes.col(0) *= -1.0;
  if (image.seen_from.rows() > 0) image.seen_from.col(0) *= -1.0;
  return image;
}

Cancellable<Findings> examine(const Examined& examined, const RunContext& context) {
  const PreparedCloud cloud = prepare_cloud(examined.cloud, {3.9, 1000, kNeighbours});
  Findings findings;
  findings.roughness = roughness_of(cloud, context);
  const ErrorModel& error = examined.error;
  const ErrorModel::HeldOut held = error.held_out(context);
  if (context.cancelled()) return std::nullopt;
  findings.held_out = held.distance;
  findings.held_out_z = held.z;
  findings.misfit = error.misfit();
  findings.strangeness = error.strangeness();
  findings.decided = error.decided();
  findings.size = error.size().value;
  findings.size_sigma = error.size().sigma;
  const Eigen::VectorXd& told = examined.registration.expected;
  findings.expected = told.size() > 0 ? told.mean() : error.expected().mean();
  MovingSurface surface(examined.model, SurfaceDetail::fine);
  const Points& final_nodes = examined.registration.nodes_in_camera;
  findings.volume_change =
      volume_of(final_nodes, examined.model.mesh) / tetrahedron_volumes(examined.model.mesh).sum() - 1.0;
  surface.move(final_nodes);
  if (examined.in_cameras_frame) findings.hidden = hidden_share(surface, cloud, context);
  if (context.cancelled()) return std::nullopt;
  look_at_pairs(surface, cloud, examined.in_cameras_frame, findings);
  if (examined.shapes != nullptr) {
    const ShapeFit& best = examined.shapes->best();
    findings.forced = (final_nodes - best.nodes_in_camera).rowwise().norm().mean();
    for (const ShapeFit& fit : examined.shapes->fits)
      if (are_rivals(fit.nodes_in_camera, best.nodes_in_camera))
        findings.rival_odds = std::min(findings.rival_odds, 0.5 * (fit.cost - best.cost));
  }
  return findings;
}

}  // namespace glisson::registration
