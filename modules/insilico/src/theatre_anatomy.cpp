// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre_anatomy.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/build.h"
#include "glisson/patient/label_map.h"

namespace glisson::insilico {
namespace {

/// The point over the middle of edge (a, b): the mean of its projections on the tangent planes at the ends,
/// by three quarters.
Eigen::Vector3d bulge(const TriangleMesh& mesh, const Points& normals, int a, int b) {
  const Eigen::Vector3d middle = 0.5 * (mesh.vertex(a) + mesh.vertex(b));
  Eigen::Vector3d lift = Eigen::Vector3d::Zero();
  for (const int v : {a, b}) {
    const Eigen::Vector3d n = normals.row(v).transpose();
    lift -= 0.5 * (middle - mesh.vertex(v)).dot(n) * n;
  }
  return middle + 0.75 * lift;
}

TriangleMesh split_in_four(const TriangleMesh& mesh) {
  const Points normals = vertex_normals(mesh);
  const std::vector<Edge> all = edges(mesh);
  TriangleMesh fine;
  fine.vertices.resize(mesh.vertices.rows() + static_cast<Eigen::Index>(all.size()), 3);
  fine.vertices.topRows(mesh.vertices.rows()) = mesh.vertices;
  for (std::size_t e = 0; e < all.size(); ++e)
    fine.vertices.row(mesh.vertices.rows() + static_cast<Eigen::Index>(e)) =
        bulge(mesh, normals, all[e].a, all[e].b).transpose();
  const auto middle = [&](int a, int b) {
    if (a > b) std::swap(a, b);
    const auto found = std::lower_bound(
        all.begin(), all.end(), std::pair(a, b),
        [](const Edge& e, const std::pair<int, int>& key) { return std::pair(e.a, e.b) < key; });
    return mesh.vertex_count() + static_cast<int>(found - all.begin());
  };
  fine.triangles.resize(4 * mesh.triangles.rows(), 3);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const int a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.row(4 * t) << a, ab, ca;
    fine.triangles.row(4 * t + 1) << b, bc, ab;
    fine.triangles.row(4 * t + 2) << c, ca, bc;
    fine.triangles.row(4 * t + 3) << ab, bc, ca;
  }
  return fine;
}

/// The point of a polyline `along` metres from vertex i (negative: backwards); false beyond its ends.
bool walk(const Points& line, Eigen::Index i, double along, Eigen::Vector3d& point) {
  const Eigen::Index step = along < 0.0 ? -1 : 1;
  double left = std::abs(along);
  for (Eigen::Index j = i; j + step >= 0 && j + step < line.rows(); j += step) {
    const Eigen::Vector3d edge = (line.row(j + step) - line.row(j)).transpose();
    if (edge.norm() >= left) {
      point = line.row(j).transpose() + left / edge.norm() * edge;
      return true;
    }
    left -= edge.norm();
  }
  return false;
}

Points notch_by_rule(const Points& margin) {
  double deepest = -std::numeric_limits<double>::infinity();
  Eigen::Index best = -1;
  for (Eigen::Index i = 0; i < margin.rows(); ++i) {
    Eigen::Vector3d before, after;
    if (!walk(margin, i, -0.03, before) || !walk(margin, i, 0.03, after)) continue;
    const double depth = margin(i, 2) - 0.5 * (before.z() + after.z());  // z is superior
    if (depth > deepest) deepest = depth, best = i;
  }
  if (best < 0) return margin.rows() > 0 ? Points(margin.row(margin.rows() / 2)) : Points(0, 3);
  return margin.row(best);
}

/// Without a landmark: posterior, superior and a little to the left of the middle, where the groove lies.
Points cava_by_rule(const TriangleMesh& surface) {
  const Eigen::Vector3d low = surface.vertices.colwise().minCoeff().transpose();
  const Eigen::Vector3d high = surface.vertices.colwise().maxCoeff().transpose();
  const Eigen::Vector3d extent = high - low;
  const Eigen::Vector3d wanted = centroid(surface) + Eigen::Vector3d(0.08, 0.5, 0.2).cwiseProduct(extent);
  Eigen::Index nearest = 0;
  (surface.vertices.rowwise() - wanted.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return surface.vertices.row(nearest);
}

/// Crossings of a ray with a closed surface tell inside from outside.
bool inside(const ClosestPointTree& tree, const Eigen::Vector3d& p) {
  const Eigen::Vector3d direction(0.5377, 0.6139, 0.5779);  // no mesh is aligned with it
  bool in = false;
  double from = 0.0;
  for (int crossing = 0; crossing < 64; ++crossing) {
    const ClosestPoint hit = tree.first_hit(p, direction, from);
    if (hit.triangle < 0) break;
    in = !in;
    from = hit.distance + 1e-7;
  }
  return in;
}

}  // namespace

TriangleMesh liver_of(const PatientModel& patient) {
  const NamedSurface* found = nullptr;
  for (const NamedSurface& surface : patient.surfaces)
    if (surface.name == "liver" || (found == nullptr && surface.structure == structure::kParenchyma))
      found = &surface;
  TriangleMesh liver = found != nullptr ? found->mesh : patient.surface.mesh;
  if (liver.triangle_count() == 0)
    throw InputError("patient", "liver", "there is no liver surface", "build the model first");
  std::vector<TriangleMesh> parts = split_components(liver);
  liver = std::move(parts.front());
  if (!is_closed(liver))
    throw InputError("patient", "liver", "its surface has holes", "give a closed surface");
  if (volume(liver) < 0.0) liver.triangles.col(1).swap(liver.triangles.col(2));
  return liver;
}

Cancellable<TetMesh> truth_mesh(const TriangleMesh& closed, int vertices, const RunContext& context) {
  model::MeshOptions meshing;
  meshing.target_vertices = vertices;
  return model::mesh_surface(closed, meshing, context);
}

TriangleMesh refine_for_drawing(TriangleMesh surface, int triangles) {
  while (surface.triangle_count() < triangles) surface = split_in_four(surface);
  return surface;
}

Points shading_normals(const TriangleMesh& surface, const std::vector<std::vector<int>>& neighbours,
                       int passes) {
  Points normals = vertex_normals(surface);
  for (int pass = 0; pass < passes; ++pass) {
    Points mean = normals;
    for (Eigen::Index v = 0; v < normals.rows(); ++v) {
      for (const int other : neighbours[static_cast<std::size_t>(v)]) mean.row(v) += normals.row(other);
      const double length = mean.row(v).norm();
      if (length > 0.0) mean.row(v) /= length;
    }
    normals = std::move(mean);
  }
  return normals;
}

Landmarks complete_landmarks(const Landmarks& known, const TriangleMesh& liver) {
  Landmarks landmarks = known;
  if (landmarks.anterior_margin.rows() < 2)
    landmarks.anterior_margin = model::detect_anterior_margin(liver, Eigen::Vector3d(0.0, -0.7, -0.7));
  if (landmarks.umbilical_notch.rows() == 0)
    landmarks.umbilical_notch = notch_by_rule(landmarks.anterior_margin);
  if (landmarks.vena_cava.rows() == 0) landmarks.vena_cava = cava_by_rule(liver);
  return landmarks;
}

void label_lesions(TetMesh& mesh, const std::vector<NamedSurface>& surfaces) {
  mesh.labels.assign(static_cast<std::size_t>(mesh.tetrahedron_count()), structure::kParenchyma);
  for (const NamedSurface& surface : surfaces) {
    if (!is_lesion(surface.structure) || surface.mesh.triangle_count() == 0) continue;
    const ClosestPointTree tree(surface.mesh);
    const Eigen::RowVector3d low = surface.mesh.vertices.colwise().minCoeff();
    const Eigen::RowVector3d high = surface.mesh.vertices.colwise().maxCoeff();
    for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
      Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
      for (int k = 0; k < 4; ++k) centre += 0.25 * mesh.vertices.row(mesh.tetrahedra(t, k));
      if ((centre.array() < low.array()).any() || (centre.array() > high.array()).any()) continue;
      if (inside(tree, centre.transpose())) mesh.labels[static_cast<std::size_t>(t)] = surface.structure;
    }
  }
}

}  // namespace glisson::insilico
