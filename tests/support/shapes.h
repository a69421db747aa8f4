// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "glisson/geometry/mesh.h"
#include "glisson/geometry/topology.h"

/// @file
/// Closed surfaces with known volumes, made of nothing but formulas.

namespace glisson::test {

/// A sphere: an icosahedron, its triangles split `splits` times.
inline TriangleMesh sphere(double radius, int splits) {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.vertices.resize(12, 3);
  mesh.vertices << -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, 0, 0, -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, g, 0, -1,
      g, 0, 1, -g, 0, -1, -g, 0, 1;
  mesh.triangles.resize(20, 3);
  mesh.triangles << 0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6,
      7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1;
  for (int pass = 0; pass < splits; ++pass) {
    std::map<std::pair<int, int>, int> middle;
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < mesh.vertex_count(); ++i) points.push_back(mesh.vertex(i));
    const auto between = [&](int a, int b) {
      const auto [found, is_new] = middle.emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (is_new) points.push_back(0.5 * (points[a] + points[b]));
      return found->second;
    };
    Triangles split(mesh.triangle_count() * 4, 3);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const int a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
      const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
      split.row(4 * t) << a, ab, ca;
      split.row(4 * t + 1) << ab, b, bc;
      split.row(4 * t + 2) << ca, bc, c;
      split.row(4 * t + 3) << ab, bc, ca;
    }
    mesh.triangles = split;
    mesh.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
      mesh.vertices.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  for (int i = 0; i < mesh.vertex_count(); ++i) mesh.vertices.row(i) *= radius / mesh.vertices.row(i).norm();
  return mesh;
}

/// A torus about the z axis: `ring` from the axis to the tube's centre, `tube` its radius.
inline TriangleMesh torus(double ring, double tube, int around, int across) {
  TriangleMesh mesh;
  mesh.vertices.resize(around * across, 3);
  mesh.triangles.resize(2 * around * across, 3);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = ring + tube * std::cos(v);
      mesh.vertices.row(i * across + j) << r * std::cos(u), r * std::sin(u), tube * std::sin(v);
      const int a = i * across + j, b = (i + 1) % around * across + j,
                c = (i + 1) % around * across + (j + 1) % across, d = i * across + (j + 1) % across;
      mesh.triangles.row(2 * a) << a, b, c;
      mesh.triangles.row(2 * a + 1) << a, c, d;
    }
  return mesh;
}

/// A box of the given edges, centred.
inline TriangleMesh box(const Eigen::Vector3d& edges) {
  TriangleMesh mesh;
  mesh.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i)
    mesh.vertices.row(i) << (i & 1 ? 0.5 : -0.5) * edges.x(), (i & 2 ? 0.5 : -0.5) * edges.y(),
        (i & 4 ? 0.5 : -0.5) * edges.z();
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6,
      1, 3, 5, 3, 7, 5;
  return mesh;
}

/// Two surfaces as one mesh.
inline TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both;
  both.vertices.resize(a.vertex_count() + b.vertex_count(), 3);
  both.vertices << a.vertices, b.vertices;
  both.triangles.resize(a.triangle_count() + b.triangle_count(), 3);
  both.triangles << a.triangles, (b.triangles.array() + a.vertex_count()).matrix();
  return both;
}

inline TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& by) {
  mesh.vertices.rowwise() += by.transpose();
  return mesh;
}

}  // namespace glisson::test
