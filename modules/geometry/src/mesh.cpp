// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glisson {
namespace {

Eigen::Vector3d scaled_normal(const TriangleMesh& mesh, int t) {
  const Eigen::Vector3d a = mesh.vertex(mesh.triangles(t, 0));
  return (mesh.vertex(mesh.triangles(t, 1)) - a).cross(mesh.vertex(mesh.triangles(t, 2)) - a);
}

double six_volumes(const TetMesh& mesh, int t) {
  const Eigen::Vector3d a = mesh.vertex(mesh.tetrahedra(t, 0));
  const Eigen::Vector3d b = mesh.vertex(mesh.tetrahedra(t, 1)) - a;
  const Eigen::Vector3d c = mesh.vertex(mesh.tetrahedra(t, 2)) - a;
  return b.cross(c).dot(mesh.vertex(mesh.tetrahedra(t, 3)) - a);
}

}  // namespace

Points triangle_normals(const TriangleMesh& mesh) {
  Points normals(mesh.triangle_count(), 3);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d n = scaled_normal(mesh, t);
    const double length = n.norm();
    normals.row(t) = length > 0.0 ? (n / length).eval().transpose() : Eigen::RowVector3d::Zero().eval();
  }
  return normals;
}

Eigen::VectorXd triangle_areas(const TriangleMesh& mesh) {
  Eigen::VectorXd areas(mesh.triangle_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) areas[t] = 0.5 * scaled_normal(mesh, t).norm();
  return areas;
}

Eigen::VectorXd vertex_areas(const TriangleMesh& mesh) {
  const Eigen::VectorXd areas = triangle_areas(mesh);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) result[mesh.triangles(t, k)] += areas[t] / 3.0;
  return result;
}

double area(const TriangleMesh& mesh) { return triangle_areas(mesh).sum(); }

double volume(const TriangleMesh& mesh) {
  if (mesh.vertex_count() == 0) return 0.0;
  // About a vertex of its own, so that a mesh far from the origin loses no digits.
  const Eigen::Vector3d origin = mesh.vertex(0);
  double six = 0.0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d a = mesh.vertex(mesh.triangles(t, 0)) - origin;
    const Eigen::Vector3d b = mesh.vertex(mesh.triangles(t, 1)) - origin;
    six += a.cross(b).dot(mesh.vertex(mesh.triangles(t, 2)) - origin);
  }
  return six / 6.0;
}

Eigen::VectorXd tetrahedron_volumes(const TetMesh& mesh) {
  Eigen::VectorXd volumes(mesh.tetrahedron_count());
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) volumes[t] = six_volumes(mesh, t) / 6.0;
  return volumes;
}

double volume(const TetMesh& mesh) { return tetrahedron_volumes(mesh).sum(); }

Eigen::Vector3d centroid(const TriangleMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0.0;
  const Eigen::VectorXd areas = triangle_areas(mesh);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    sum += areas[t] / 3.0 *
           (mesh.vertex(mesh.triangles(t, 0)) + mesh.vertex(mesh.triangles(t, 1)) +
            mesh.vertex(mesh.triangles(t, 2)));
    total += areas[t];
  }
  return total > 0.0 ? (sum / total).eval() : sum;
}

Eigen::MatrixX2d dihedral_angles(const TetMesh& mesh) {
  static constexpr int kFaces[4][3] = {
      {1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};  // opposite each corner, outwards
  Eigen::MatrixX2d angles(mesh.tetrahedron_count(), 2);
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    Eigen::Vector3d normals[4];
    for (int f = 0; f < 4; ++f) {
      const Eigen::Vector3d a = mesh.vertex(mesh.tetrahedra(t, kFaces[f][0]));
      normals[f] = (mesh.vertex(mesh.tetrahedra(t, kFaces[f][1])) - a)
                       .cross(mesh.vertex(mesh.tetrahedra(t, kFaces[f][2])) - a);
    }
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        const double angle =
            std::numbers::pi - std::atan2(normals[i].cross(normals[j]).norm(), normals[i].dot(normals[j]));
        low = std::min(low, angle);
        high = std::max(high, angle);
      }
    }
    angles.row(t) << low * 180.0 / std::numbers::pi, high * 180.0 / std::numbers::pi;
  }
  return angles;
}

}  // namespace glisson
