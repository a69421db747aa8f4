// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "glisson/geometry/rigid.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"

/// A liver-like body made of formulas, so that any two meshes of it are of one shape: a dome over a flat
/// face, thick to one side, with a rim that is sharp in front and a notch in it. Metres.
namespace glisson::phantom {

/// A point of the body from parameters in [-1, 1]^3 (w: from the flat face to the dome).
inline Eigen::Vector3d shape(double u, double v, double w) {
  // Square to disc (Shirley and Chiu's concentric map keeps the cells fair).
  double r = 0.0, phi = 0.0;
  if (std::abs(u) > std::abs(v)) {
    r = u, phi = std::numbers::pi / 4.0 * (v / u);
  } else if (v != 0.0) {
    r = v, phi = std::numbers::pi / 2.0 - std::numbers::pi / 4.0 * (u / v);
  }
  double x = r * std::cos(phi), y = r * std::sin(phi);
  const double radius2 = x * x + y * y;
  const double front = std::max(0.0, -y);
  const double notch = 0.22 * std::exp(-std::pow((x - 0.15) / 0.12, 2)) * front;
  const double thick =
      (0.62 - 0.34 * x) * std::pow(std::max(0.0, 1.0 - radius2), 0.6) + 0.05 + 0.05 * (y + 1.0);
  const double top = thick, bottom = -0.25 * thick * (1.0 + 0.5 * y);
  const double z = bottom + (top - bottom) * 0.5 * (w + 1.0);
  return {0.105 * x * (1.0 + 0.08 * y), 0.075 * (y + notch), 0.105 * z};
}

/// A regular grid of nx x ny x nz cells, six tetrahedra each.
inline TetMesh tetrahedra(int nx, int ny, int nz) {
  TetMesh mesh;
  mesh.vertices.resize((nx + 1) * (ny + 1) * (nz + 1), 3);
  const auto node = [&](int i, int j, int k) { return i + (nx + 1) * (j + (ny + 1) * k); };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        mesh.vertices.row(node(i, j, k)) =
            shape(2.0 * i / nx - 1.0, 2.0 * j / ny - 1.0, 2.0 * k / nz - 1.0).transpose();
  static constexpr int kWays[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  mesh.tetrahedra.resize(6 * nx * ny * nz, 4);
  int next = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        for (const auto& way : kWays) {
          std::array<int, 3> at{i, j, k};
          mesh.tetrahedra(next, 0) = node(at[0], at[1], at[2]);
          for (int step = 0; step < 3; ++step) {
            ++at[static_cast<std::size_t>(way[step])];
            mesh.tetrahedra(next, step + 1) = node(at[0], at[1], at[2]);
          }
          ++next;
        }
  orient_tetrahedra(mesh);
  return mesh;
}

inline Landmarks landmarks() {
  Landmarks landmarks;
  constexpr int kCount = 41;
  landmarks.anterior_margin.resize(kCount, 3);
  for (int i = 0; i < kCount; ++i)
    landmarks.anterior_margin.row(i) = shape(-0.9 + 1.8 * i / (kCount - 1), -1.0, 0.0).transpose();
  landmarks.umbilical_notch.resize(1, 3);
  int deepest = 0;
  for (int i = 0; i < kCount; ++i) {
    const double x = landmarks.anterior_margin(i, 0);
    if (x > -0.02 && x < 0.05 && landmarks.anterior_margin(i, 1) > landmarks.anterior_margin(deepest, 1))
      deepest = i;
    if (deepest == 0 && x > -0.02) deepest = i;
  }
  landmarks.umbilical_notch.row(0) = landmarks.anterior_margin.row(deepest);
  // Where the cava runs: the back of the flat face.
  landmarks.vena_cava.resize(9, 3);
  for (int i = 0; i < 9; ++i)
    landmarks.vena_cava.row(i) =
        shape(0.15 * (i % 3 - 1), 0.55 + 0.15 * static_cast<double>(i / 3), -1.0).transpose();
  return landmarks;
}

inline PatientModel model(int nx, int ny, int nz) {
  PatientModel model;
  model.mesh = tetrahedra(nx, ny, nz);
  model.mesh.labels.assign(static_cast<std::size_t>(model.mesh.tetrahedron_count()), 1);
  model.surface = boundary_surface(model.mesh);
  model.landmarks = landmarks();
  return model;
}

/// A straight vessel inside, `beams` pieces.
inline VesselTree vessel(int beams, double y) {
  VesselTree tree;
  tree.structure = 2;
  tree.nodes.resize(beams + 1, 3);
  for (int i = 0; i <= beams; ++i) {
    tree.nodes.row(i) = shape(-0.7 + 1.4 * i / beams, y, 0.0).transpose();
    tree.radii.push_back(3e-3);
    if (i > 0) tree.beams.push_back({i - 1, i});
  }
  tree.root = 0;
  return tree;
}

/// A camera pose from which the dome and the front rim are seen.
inline CameraFromCt view(double turn = 0.0) {
  CameraFromCt pose;
  // The dome's +z looks back at the camera (-z), tipped so that the rim is seen.
  pose.rotation = (Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(std::numbers::pi - 0.5, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation = Eigen::Vector3d(0.01, -0.005, 0.16);
  return pose;
}

struct PatchOptions {
  double share = 0.3, density_per_cm2 = 3.9, noise = 0.5e-3;
  int outliers = 0;
  unsigned seed = 1;
};

/// What a camera at the origin sees of a deformed surface: the camera-facing points nearest to the front
/// rim's middle, `share` of the surface's area, labelled by the distance to the carried landmarks.
/// @param nodes of `mesh` in the camera's frame; @param rest the landmarks and the mesh's rest shape.
inline LabelledCloud patch(const PatientModel& rest, const Points& nodes, const PatchOptions& options) {
  TriangleMesh now = rest.surface.mesh;
  for (int i = 0; i < now.vertex_count(); ++i)
    now.vertices.row(i) = nodes.row(rest.surface.node_of_vertex[static_cast<std::size_t>(i)]);
  const Points margin = bind_points(rest.mesh, rest.landmarks.anterior_margin).apply(rest.mesh, nodes);
  const Points notch = bind_points(rest.mesh, rest.landmarks.umbilical_notch).apply(rest.mesh, nodes);
  const Eigen::VectorXd areas = triangle_areas(now);
  const Points normals = triangle_normals(now);
  std::mt19937 random(options.seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal(0.0, 1.0);
  struct Sample {
    Eigen::Vector3d p, n;
    double rank;
  };
  std::vector<Sample> samples;
  std::discrete_distribution<int> which(areas.data(), areas.data() + areas.size());
  const auto wanted = static_cast<std::size_t>(areas.sum() * 1e4 * options.density_per_cm2);
  const Eigen::Vector3d middle = notch.row(0).transpose();
  for (std::size_t i = 0; i < wanted; ++i) {
    const int t = which(random);
    double a = uniform(random), b = uniform(random);
    if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
    const Eigen::Vector3d p = now.vertex(now.triangles(t, 0)) * (1.0 - a - b) +
                              now.vertex(now.triangles(t, 1)) * a + now.vertex(now.triangles(t, 2)) * b;
    const Eigen::Vector3d n = normals.row(t).transpose();
    if (n.dot(p) < -0.1 * p.norm()) samples.push_back({p, n, (p - middle).norm()});
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.rank < b.rank; });
  samples.resize(
      std::min(samples.size(), static_cast<std::size_t>(options.share * static_cast<double>(wanted))));
  LabelledCloud cloud;
  cloud.points.resize(static_cast<Eigen::Index>(samples.size()), 3);
  cloud.normals.resize(cloud.points.rows(), 3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    Eigen::Vector3d p = samples[i].p;
    Feature feature = Feature::surface;
    if ((margin.rowwise() - p.transpose()).rowwise().norm().minCoeff() < 6e-3)
      feature = Feature::anterior_margin;
    if ((notch.rowwise() - p.transpose()).rowwise().norm().minCoeff() < 10e-3)
      feature = Feature::umbilical_notch;
    const double z = normal(random), y = normal(random), x = normal(random);
    p += options.noise * Eigen::Vector3d(x, y, z);
    if (static_cast<int>(i) < options.outliers) p *= 1.0 + 0.2 * (uniform(random) - 0.5);
    cloud.points.row(row) = p.transpose();
    cloud.normals.row(row) = samples[i].n.transpose();
    cloud.features.push_back(feature);
  }
  return cloud;
}

}  // namespace glisson::phantom
