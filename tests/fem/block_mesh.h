// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/patient/patient_model.h"

/// @file
/// Small models for the mechanics' tests: blocks of tetrahedra, vessels through them.

namespace glisson::fem_test {

/// A block of nx x ny x nz cells from the origin, six tetrahedra a cell around its diagonal (Kuhn).
inline TetMesh block_mesh(const Eigen::Vector3i& cells, const Eigen::Vector3d& size) {
  const auto node = [&](int x, int y, int z) { return (z * (cells.y() + 1) + y) * (cells.x() + 1) + x; };
  TetMesh mesh;
  mesh.vertices.resize((cells.x() + 1) * (cells.y() + 1) * (cells.z() + 1), 3);
  for (int z = 0; z <= cells.z(); ++z)
    for (int y = 0; y <= cells.y(); ++y)
      for (int x = 0; x <= cells.x(); ++x)
        mesh.vertices.row(node(x, y, z)) << size.x() * x / cells.x(), size.y() * y / cells.y(),
            size.z() * z / cells.z();
  static constexpr std::array<std::array<int, 3>, 6> kAxes{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  mesh.tetrahedra.resize(6 * cells.prod(), 4);
  int t = 0;
  for (int z = 0; z < cells.z(); ++z)
    for (int y = 0; y < cells.y(); ++y)
      for (int x = 0; x < cells.x(); ++x)
        for (const auto& axes : kAxes) {
          Eigen::Vector3i corner(x, y, z);
          std::array<int, 4> nodes{node(x, y, z)};
          for (std::size_t k = 0; k < 3; ++k) {
            ++corner[axes[k]];
            nodes[k + 1] = node(corner.x(), corner.y(), corner.z());
          }
          // An odd permutation of the axes turns the tetrahedron inside out.
          const bool odd = (axes[0] + 1) % 3 != axes[1];
          if (odd) std::swap(nodes[2], nodes[3]);
          mesh.tetrahedra.row(t++) << nodes[0], nodes[1], nodes[2], nodes[3];
        }
  return mesh;
}

/// Moves inner nodes a little, so that no element is special. `amount` in cells' smallest size.
inline void shake(TetMesh& mesh, double amount, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  const Eigen::RowVector3d low = mesh.vertices.colwise().minCoeff(),
                           high = mesh.vertices.colwise().maxCoeff();
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double step = uniform(random);
      if (mesh.vertices(i, k) > low[k] + 1e-9 && mesh.vertices(i, k) < high[k] - 1e-9)
        mesh.vertices(i, k) += step;
    }
}

/// A vessel along a line of `beams` equal beams.
inline VesselTree straight_vessel(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int beams,
                                  double radius) {
  VesselTree tree;
  tree.structure = structure::kPortalVein;
  tree.nodes.resize(beams + 1, 3);
  for (int i = 0; i <= beams; ++i) {
    tree.nodes.row(i) = (from + (to - from) * i / beams).transpose();
    tree.radii.push_back(radius);
    if (i > 0) tree.beams.push_back({i - 1, i});
  }
  tree.root = 0;
  return tree;
}

inline Points noise(Eigen::Index rows, double amount, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  Points points(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (int k = 0; k < 3; ++k) points(i, k) = uniform(random);
  return points;
}

inline Eigen::Matrix3d random_rotation(unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond{normal(random), normal(random), normal(random), normal(random)}
      .normalized()
      .toRotationMatrix();
}

/// The points, each moved by a smooth large bend and stretch.
inline Points bent(const Points& rest) {
  Points x = rest;
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const double a = 12.0 * rest(i, 0);  // radians a metre
    x(i, 0) = rest(i, 0) * 1.1 - rest(i, 1) * std::sin(a);
    x(i, 1) = rest(i, 1) * std::cos(a) + 3.0 * rest(i, 0) * rest(i, 0);
    x(i, 2) = 0.95 * rest(i, 2) + 0.2 * rest(i, 0);
  }
  return x;
}

/// Nodes whose coordinate `axis` is within 1e-9 of `value`.
inline std::vector<int> nodes_at(const TetMesh& mesh, int axis, double value) {
  std::vector<int> nodes;
  for (int i = 0; i < mesh.vertex_count(); ++i)
    if (std::abs(mesh.vertices(i, axis) - value) < 1e-9) nodes.push_back(i);
  return nodes;
}

}  // namespace glisson::fem_test
