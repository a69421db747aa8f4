// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_patches.h"

#include "farthest_first.h"

namespace glisson::registration {

/// Cosine between normals above which a patch goes on: not through a thin lobe to its other face.
constexpr double kAlike = 0.2;

fem::NodalColumns unit_forces(const std::vector<ForcePatch>& patches, int node_count) {
  fem::NodalColumns forces =
      fem::NodalColumns::Zero(3L * node_count, 3L * static_cast<Eigen::Index>(patches.size()));
  for (std::size_t j = 0; j < patches.size(); ++j)
    for (const auto& [node, weight] : patches[j].weights)
      for (int c = 0; c < 3; ++c) forces(3L * node + c, 3 * static_cast<Eigen::Index>(j) + c) = weight;
  return forces;
}

ForceSurface::ForceSurface(const BoundarySurface& surface, const Points& rest,
                           const std::vector<char>& fixed) {
  TriangleMesh mesh = surface.mesh;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    mesh.vertices.row(v) = rest.row(surface.node_of_vertex[static_cast<std::size_t>(v)]);
  const Points normals = vertex_normals(mesh);
  const Eigen::VectorXd areas = vertex_areas(mesh);
  std::vector<int> kept;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (const int node = surface.node_of_vertex[static_cast<std::size_t>(v)];
        fixed[static_cast<std::size_t>(node)] == 0) {
      nodes_.push_back(node);
      kept.push_back(v);
    }
  positions_ = mesh.vertices(kept, Eigen::all);
  normals_ = normals(kept, Eigen::all);
  areas_ = areas(kept);
}

ForcePatch ForceSurface::patch(Eigen::Index centre, double radius) const {
  ForcePatch patch;
  patch.node = nodes_[static_cast<std::size_t>(centre)];
  double sum = 0.0;
  for (Eigen::Index i = 0; i < positions_.rows(); ++i) {
    const double share = (positions_.row(i) - positions_.row(centre)).squaredNorm() / (radius * radius);
    if (share >= 1.0 || !(normals_.row(i).dot(normals_.row(centre)) > kAlike)) continue;
    patch.weights.emplace_back(nodes_[static_cast<std::size_t>(i)], (1.0 - share) * areas_[i]);
    sum += patch.weights.back().second;
  }
  for (auto& [node, weight] : patch.weights) weight /= sum;
  return patch;
}

std::vector<ForcePatch> ForceSurface::patches(const Points& seen, const PatchGrid& grid) const {
  std::vector<Eigen::Index> candidates;
  if (seen.rows() == 0) return {};
  for (Eigen::Index i = 0; i < positions_.rows(); ++i)
    if ((seen.rowwise() - positions_.row(i)).rowwise().squaredNorm().minCoeff() < grid.reach * grid.reach)
      candidates.push_back(i);
  std::vector<ForcePatch> patches;
  if (candidates.empty()) return patches;
  const Points open = positions_(candidates, Eigen::all);
  Eigen::Index first = 0;
  (open.rowwise() - seen.colwise().mean()).rowwise().squaredNorm().minCoeff(&first);
  for (const Eigen::Index centre : farthest_first(open, grid.spacing, first).chosen)
    patches.push_back(patch(candidates[static_cast<std::size_t>(centre)], grid.radius));
  return patches;
}

}  // namespace glisson::registration
