// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/proposal_actors.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "actor_group.h"
#include "glisson/ui/scene/surface_shapes.h"

namespace glisson::scene {
namespace {

constexpr int kRings = 12, kSectors = 20;                        // of an ellipsoid
constexpr int kEllipsoidsOfALine = 9;                            // at most: between them the eye goes on
constexpr double kEllipsoidOpacity = 0.28;                       // of one; of a line's fewer
constexpr double kBall = 3.5e-3, kTube = 1.2e-3, kDot = 0.9e-3;  // radii, metres
constexpr double kChosen = 1.5;                                  // over the radii

TriangleMesh joined(const std::vector<TriangleMesh>& parts) {
  TriangleMesh all;
  for (const TriangleMesh& part : parts) {
    const Eigen::Index v = all.vertices.rows(), t = all.triangles.rows();
    all.vertices.conservativeResize(v + part.vertices.rows(), 3);
    all.vertices.bottomRows(part.vertices.rows()) = part.vertices;
    all.triangles.conservativeResize(t + part.triangles.rows(), 3);
    all.triangles.bottomRows(part.triangles.rows()) = part.triangles.array() + static_cast<int>(v);
  }
  return all;
}

}  // namespace

TriangleMesh ellipsoid(const Eigen::Vector3d& centre, const Eigen::Matrix3d& covariance, double distance2) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) *= -1.0;
  const Eigen::Matrix3d shape =
      axes * (distance2 * solver.eigenvalues().cwiseMax(0.0)).cwiseSqrt().asDiagonal();
  TriangleMesh mesh{Points(2 + (kRings - 1) * kSectors, 3), Triangles(2 * kSectors * (kRings - 1), 3)};
  const auto put = [&](Eigen::Index row, const Eigen::Vector3d& unit) {
    mesh.vertices.row(row) = (centre + shape * unit).transpose();
  };
  put(0, Eigen::Vector3d::UnitZ());
  put(1, -Eigen::Vector3d::UnitZ());
  const auto at = [](int ring, int sector) { return 2 + (ring - 1) * kSectors + sector % kSectors; };
  for (int ring = 1; ring < kRings; ++ring)
    for (int sector = 0; sector < kSectors; ++sector) {
      const double down = std::numbers::pi * ring / kRings,
                   round = 2.0 * std::numbers::pi * sector / kSectors;
      put(at(ring, sector),
          {std::sin(down) * std::cos(round), std::sin(down) * std::sin(round), std::cos(down)});
    }
  Eigen::Index t = 0;
  for (int sector = 0; sector < kSectors; ++sector) {
    mesh.triangles.row(t++) << 0, at(1, sector), at(1, sector + 1);
    mesh.triangles.row(t++) << 1, at(kRings - 1, sector + 1), at(kRings - 1, sector);
    for (int ring = 1; ring + 1 < kRings; ++ring) {
      mesh.triangles.row(t++) << at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1);
      mesh.triangles.row(t++) << at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1);
    }
  }
  return mesh;
}

struct ProposalActors::Impl {
  ActorGroup actors;

  explicit Impl(vtkRenderer& to) : actors(to) {}

  void add(const ProposalMark& mark) {
    const double thick = mark.is_chosen ? kChosen : 1.0;
    if (mark.faces.triangle_count() > 0) {
      const auto surface = make_poly_data(mark.faces);
      add_normals(*surface);
      vtkProperty& look = actors.add(surface, mark.colour);
      look.SetAmbient(0.35);  // its colour is told where it is seen from the side, too
      look.SetDiffuse(0.65);
    }
    if (mark.points.rows() == 0) return;
    if (mark.area.rows() > 0) actors.add(balls(mark.area, thick * kDot), mark.colour);
    if (mark.is_line && mark.points.rows() > 1)
      actors.add(make_poly_data(polyline_tube(mark.points, thick * kTube)), mark.colour);
    else
      actors.add(balls(mark.points, thick * kBall), mark.colour);
    if (!mark.is_chosen) return;
    std::vector<TriangleMesh> parts;
    const Eigen::Index count = mark.points.rows();
    const Eigen::Index step =
        std::max<Eigen::Index>(1, (count + kEllipsoidsOfALine - 2) / kEllipsoidsOfALine);
    for (Eigen::Index k = 0; k < count; k += step)
      parts.push_back(ellipsoid(mark.points.row(k).transpose(), mark.covariances[static_cast<std::size_t>(k)],
                                mark.ellipsoid2));
    const auto data = make_poly_data(joined(parts));
    add_normals(*data);
    vtkProperty& look = actors.add(data, mark.colour);
    look.SetOpacity(parts.size() > 1 ? 0.5 * kEllipsoidOpacity : kEllipsoidOpacity);
    look.SetBackfaceCulling(1);
  }
};

ProposalActors::ProposalActors(vtkRenderer& renderer) : impl_(std::make_unique<Impl>(renderer)) {}

ProposalActors::~ProposalActors() = default;

void ProposalActors::show(const std::vector<ProposalMark>& marks) {
  impl_->actors.clear();
  for (const ProposalMark& mark : marks) impl_->add(mark);
}

int ProposalActors::actor_count() const { return impl_->actors.size(); }

}  // namespace glisson::scene
