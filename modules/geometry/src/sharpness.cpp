// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/sharpness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "glisson/geometry/topology.h"

namespace glisson {
namespace {

/// Every triangle cut into four: the same surface with more vertices.
TriangleMesh subdivided(const TriangleMesh& mesh) {
  const std::vector<Edge> all = edges(mesh);
  std::map<std::pair<int, int>, int> middle;
  TriangleMesh fine;
  fine.vertices.resize(mesh.vertex_count() + static_cast<Eigen::Index>(all.size()), 3);
  fine.vertices.topRows(mesh.vertex_count()) = mesh.vertices;
  for (std::size_t e = 0; e < all.size(); ++e) {
    const int at = mesh.vertex_count() + static_cast<int>(e);
    middle[{all[e].a, all[e].b}] = at;
    fine.vertices.row(at) = 0.5 * (mesh.vertices.row(all[e].a) + mesh.vertices.row(all[e].b));
  }
  const auto between = [&](int a, int b) { return middle.at({std::min(a, b), std::max(a, b)}); };
  fine.triangles.resize(4L * mesh.triangle_count(), 3);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const int a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
    const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
    fine.triangles.row(4L * t) << a, ab, ca;
    fine.triangles.row(4L * t + 1) << ab, b, bc;
    fine.triangles.row(4L * t + 2) << ca, bc, c;
    fine.triangles.row(4L * t + 3) << ab, bc, ca;
  }
  return fine;
}

double mean_edge(const TriangleMesh& mesh) {
  double sum = 0.0;
  const std::vector<Edge> all = edges(mesh);
  for (const Edge& edge : all) sum += (mesh.vertex(edge.a) - mesh.vertex(edge.b)).norm();
  return all.empty() ? 0.0 : sum / static_cast<double>(all.size());
}

struct Patch {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< the mean one; zero: none
  double spread = 0.0;
};

/// Measures one vertex after the other.
class Patches {
 public:
  explicit Patches(const TriangleMesh& mesh)
      : mesh_(mesh), normals_(triangle_normals(mesh)), areas_(triangle_areas(mesh)) {
    triangles_of_.resize(static_cast<std::size_t>(mesh.vertex_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t)
      for (int k = 0; k < 3; ++k) triangles_of_[mesh.triangles(t, k)].push_back(t);
    seen_.assign(static_cast<std::size_t>(mesh.triangle_count()), -1);
  }

  /// Around a vertex.
  Patch measure(int v) {
    const Eigen::Vector3d p = mesh_.vertex(v);
    std::vector<int> patch = triangles_of_[v];
    for (const int t : patch) seen_[t] = v;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(), place = normal;
    double area = 0.0;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const int t = patch[next];
      const Eigen::Vector3d c = centre(t);
      normal += areas_[t] * normals_.row(t).transpose();
      place += areas_[t] * c;
      area += areas_[t];
      for (int k = 0; k < 3; ++k)
        for (const int neighbour : triangles_of_[mesh_.triangles(t, k)]) {
          if (seen_[neighbour] == v || (centre(neighbour) - p).norm() > kSharpnessRadius) continue;
          seen_[neighbour] = v;
          patch.push_back(neighbour);
        }
    }
    if (!(area > 0.0) || !(normal.norm() > 0.0)) return {};
    const double spread = 1.0 - normal.norm() / area;
    return {normal.normalized(), (p - place / area).dot(normal) >= 0.0 ? spread : -spread};
  }

 private:
  Eigen::Vector3d centre(int t) const {
    return (mesh_.vertex(mesh_.triangles(t, 0)) + mesh_.vertex(mesh_.triangles(t, 1)) +
            mesh_.vertex(mesh_.triangles(t, 2))) /
           3.0;
  }

  const TriangleMesh& mesh_;
  Points normals_;
  Eigen::VectorXd areas_;
  std::vector<std::vector<int>> triangles_of_;
  std::vector<int> seen_;
};

}  // namespace

TriangleMesh refined(TriangleMesh mesh, double edge) {
  while (mean_edge(mesh) > edge && mesh.triangle_count() < 400000) mesh = subdivided(mesh);
  return mesh;
}

Sharpness::Sharpness(const TriangleMesh& mesh)
    : mean_normal_(Points::Zero(mesh.vertex_count(), 3)),
      value_(static_cast<std::size_t>(mesh.vertex_count()), 0.0) {
  Patches patches(mesh);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Patch patch = patches.measure(v);
    mean_normal_.row(v) = patch.normal.transpose();
    value_[v] = patch.spread;
  }
}

}  // namespace glisson
