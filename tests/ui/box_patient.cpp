// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_patient.h"

#include <array>
#include <cmath>
#include <vector>

namespace glisson {

TetMesh block_mesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int n) {
  TetMesh mesh;
  const int side = n + 1;
  mesh.vertices.resize(side * side * side, 3);
  const auto id = [&](int x, int y, int z) { return x + side * (y + side * z); };
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        mesh.vertices.row(id(x, y, z)) =
            (low.array() + (high - low).array() * Eigen::Array3d(x, y, z) / n).matrix().transpose();
  std::vector<std::array<int, 4>> tetrahedra;
  static constexpr int kPaths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        for (const auto& path : kPaths) {
          Eigen::Vector3i at(x, y, z);
          std::array<int, 4> nodes{id(x, y, z), 0, 0, 0};
          for (std::size_t k = 0; k < 3; ++k) {
            ++at[path[k]];
            nodes[k + 1] = id(at.x(), at.y(), at.z());
          }
          tetrahedra.push_back(nodes);
        }
  mesh.tetrahedra.resize(static_cast<Eigen::Index>(tetrahedra.size()), 4);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    for (int k = 0; k < 4; ++k)
      mesh.tetrahedra(static_cast<Eigen::Index>(t), k) = tetrahedra[t][static_cast<std::size_t>(k)];
  orient_tetrahedra(mesh);
  mesh.labels.assign(tetrahedra.size(), structure::kParenchyma);
  return mesh;
}

TriangleMesh ball_mesh(const Eigen::Vector3d& centre, double radius, int n) {
  TriangleMesh mesh;
  const int around = 2 * n;
  mesh.vertices.resize(2 + (n - 1) * around, 3);
  mesh.vertices.row(0) = (centre + Eigen::Vector3d(0, 0, radius)).transpose();
  mesh.vertices.row(1) = (centre - Eigen::Vector3d(0, 0, radius)).transpose();
  const auto id = [&](int ring, int k) { return 2 + (ring - 1) * around + (k % around); };
  for (int ring = 1; ring < n; ++ring)
    for (int k = 0; k < around; ++k) {
      const double theta = M_PI * ring / n, phi = 2.0 * M_PI * k / around;
      mesh.vertices.row(id(ring, k)) =
          (centre + radius * Eigen::Vector3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                             std::cos(theta)))
              .transpose();
    }
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < around; ++k) {
    triangles.push_back({0, id(1, k), id(1, k + 1)});
    triangles.push_back({1, id(n - 1, k + 1), id(n - 1, k)});
    for (int ring = 1; ring + 1 < n; ++ring) {
      triangles.push_back({id(ring, k), id(ring + 1, k), id(ring + 1, k + 1)});
      triangles.push_back({id(ring, k), id(ring + 1, k + 1), id(ring, k + 1)});
    }
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      mesh.triangles(static_cast<Eigen::Index>(t), k) = triangles[t][static_cast<std::size_t>(k)];
  return mesh;
}

PatientModel box_patient() {
  PatientModel model;
  model.mesh = block_mesh({-0.06, -0.04, -0.025}, {0.06, 0.04, 0.025}, 5);
  model.surface = boundary_surface(model.mesh);
  model.surfaces.push_back({structure::kParenchyma, "liver", model.surface.mesh});
  const auto branch = [](Label structure, double y) {
    VesselTree tree;
    tree.structure = structure;
    tree.nodes.resize(5, 3);
    for (int i = 0; i < 5; ++i) tree.nodes.row(i) << -0.05 + 0.025 * i, y, 0.005 * std::sin(i);
    tree.radii = {5e-3, 4.5e-3, 4e-3, 3.5e-3, 3e-3};
    tree.beams = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
    tree.root = 0;
    return tree;
  };
  model.vessels = {branch(structure::kPortalVein, -0.02), branch(structure::kHepaticVeins, 0.02)};
  model.surfaces.push_back({structure::kFirstLesion, "lesion_1", ball_mesh({0.03, 0.0, 0.0}, 0.006, 12)});
  model.landmarks.anterior_margin.resize(3, 3);
  model.landmarks.anterior_margin << -0.06, 0.04, -0.025, 0.0, 0.04, -0.025, 0.06, 0.04, -0.025;
  model.landmarks.umbilical_notch.resize(1, 3);
  model.landmarks.umbilical_notch << 0.0, 0.04, -0.025;
  return model;
}

Camera laparoscope(double scale) {
  Camera camera;
  camera.width = static_cast<int>(640 * scale);
  camera.height = static_cast<int>(360 * scale);
  camera.matrix << 520.0 * scale, 3.0 * scale, 341.0 * scale, 0.0, 505.0 * scale, 162.5 * scale, 0.0, 0.0,
      1.0;
  camera.distortion << -0.28, 0.09, 1.2e-3, -8e-4, 0.0;
  return camera;
}

}  // namespace glisson
