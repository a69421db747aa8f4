// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/model/quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "glisson/patient/label_map.h"

namespace glisson::model {
namespace {

/// Counter-clockwise seen from outside, for a positively oriented tetrahedron.
constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

std::array<double, 6> dihedrals_deg(const TetMesh& mesh, int tetrahedron) {
  std::array<Eigen::Vector3d, 4> normals;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto corner = [&](int k) { return mesh.vertex(mesh.tetrahedra(tetrahedron, kFaces[f][k])); };
    normals[f] = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
  }
  std::array<double, 6> angles{};
  std::size_t next = 0;
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t g = f + 1; g < 4; ++g)
      angles[next++] =
          180.0 / std::numbers::pi * std::acos(std::clamp(-normals[f].dot(normals[g]), -1.0, 1.0));
  return angles;
}

}  // namespace

std::array<int, kDihedralBins> dihedral_histogram(const TetMesh& mesh) {
  std::array<int, kDihedralBins> bins{};
  for (int t = 0; t < mesh.tetrahedron_count(); ++t)
    for (const double angle : dihedrals_deg(mesh, t))
      ++bins[static_cast<std::size_t>(std::min(kDihedralBins - 1, static_cast<int>(angle / 10.0)))];
  return bins;
}

std::vector<int> worst_tetrahedra(const TetMesh& mesh, int count) {
  std::vector<int> order(static_cast<std::size_t>(mesh.tetrahedron_count()));
  std::iota(order.begin(), order.end(), 0);
  if (order.empty() || count <= 0) return {};
  const Eigen::VectorXd smallest = dihedral_angles(mesh).col(0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return smallest[a] < smallest[b]; });
  order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
  return order;
}

TriangleMesh tetrahedra_as_surface(const TetMesh& mesh, const std::vector<int>& tetrahedra) {
  TriangleMesh surface;
  const auto count = static_cast<Eigen::Index>(tetrahedra.size());
  surface.vertices.resize(4 * count, 3);
  surface.triangles.resize(4 * count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int t = tetrahedra[static_cast<std::size_t>(i)];
    for (int k = 0; k < 4; ++k) {
      surface.vertices.row(4 * i + k) = mesh.vertices.row(mesh.tetrahedra(t, k));
      for (int c = 0; c < 3; ++c) surface.triangles(4 * i + k, c) = static_cast<int>(4 * i) + kFaces[k][c];
    }
  }
  return surface;
}

double mean_edge_length(const TetMesh& mesh) {
  std::set<std::pair<int, int>> edges;
  for (int t = 0; t < mesh.tetrahedron_count(); ++t)
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b) edges.insert(std::minmax(mesh.tetrahedra(t, a), mesh.tetrahedra(t, b)));
  double sum = 0.0;
  for (const auto& [a, b] : edges) sum += (mesh.vertices.row(a) - mesh.vertices.row(b)).norm();
  return edges.empty() ? 0.0 : sum / static_cast<double>(edges.size());
}

std::vector<LesionVolume> lesion_volumes(const PatientModel& model) {
  std::map<Label, LesionVolume> lesions;
  for (const NamedSurface& surface : model.surfaces)
    if (is_lesion(surface.structure)) lesions[surface.structure].volume += std::abs(volume(surface.mesh));
  const Eigen::VectorXd volumes = tetrahedron_volumes(model.mesh);
  for (std::size_t t = 0; t < model.mesh.labels.size(); ++t) {
    const int code = model.mesh.labels[t];
    if (is_lesion(code))
      lesions[static_cast<Label>(code)].mesh_volume += volumes[static_cast<Eigen::Index>(t)];
  }
  std::vector<LesionVolume> result;
  for (auto& [label, lesion] : lesions) {
    lesion.label = label;
    lesion.diameter =
        std::cbrt(6.0 / std::numbers::pi * (lesion.volume > 0.0 ? lesion.volume : lesion.mesh_volume));
    result.push_back(lesion);
  }
  return result;
}

TreeSummary tree_summary(const VesselTree& tree) {
  TreeSummary summary;
  summary.structure = tree.structure;
  summary.beams = static_cast<int>(tree.beams.size());
  std::vector<int> degree(tree.radii.size(), 0);
  for (const auto& [a, b] : tree.beams) {
    ++degree[static_cast<std::size_t>(a)];
    ++degree[static_cast<std::size_t>(b)];
    summary.length += (tree.nodes.row(a) - tree.nodes.row(b)).norm();
  }
  for (std::size_t i = 0; i < degree.size(); ++i) {
    if (degree[i] > 2) ++summary.forks;
    if (degree[i] == 1 && static_cast<int>(i) != tree.root) ++summary.tips;
  }
  if (tree.root >= 0) {
    summary.root = tree.nodes.row(tree.root).transpose();
    summary.root_radius = tree.radii[static_cast<std::size_t>(tree.root)];
  }
  return summary;
}

std::vector<TreeSummary> tree_summaries(const PatientModel& model) {
  std::vector<TreeSummary> result;
  for (const VesselTree& tree : model.vessels) result.push_back(tree_summary(tree));
  return result;
}

}  // namespace glisson::model
