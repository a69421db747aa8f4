// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "glisson/insilico/patient.h"

/// @file
/// What the tests of the synthetic patient ask of it, by means of their own.

namespace glisson::test {

using insilico::SyntheticPatient;

inline const TriangleMesh& surface(const SyntheticPatient& patient, Label structure) {
  for (const NamedSurface& named : patient.surfaces)
    if (named.structure == structure) return named.mesh;
  throw std::runtime_error("no such surface");
}

inline const VesselTree& tree(const SyntheticPatient& patient, Label structure) {
  for (const VesselTree& candidate : patient.trees)
    if (candidate.structure == structure) return candidate;
  throw std::runtime_error("no such tree");
}

inline bool of_liver(Label label) {
  return label == structure::kParenchyma || label == structure::kPortalVein ||
         label == structure::kHepaticVeins || is_lesion(label);
}

/// Whether a point lies inside a closed mesh: rays along x cross it an odd number of times.
inline bool inside_mesh(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  // Off the lattice that the vertices lie on, so that no ray meets an edge.
  const Eigen::Vector3d p = point + Eigen::Vector3d(0.0, 3.1e-6, 4.7e-6);
  int crossings = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d a = mesh.vertex(mesh.triangles(t, 0)) - p,
                          b = mesh.vertex(mesh.triangles(t, 1)) - p,
                          c = mesh.vertex(mesh.triangles(t, 2)) - p;
    const double ab = a.y() * b.z() - a.z() * b.y(), bc = b.y() * c.z() - b.z() * c.y(),
                 ca = c.y() * a.z() - c.z() * a.y();
    if (!((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))) continue;
    if ((a.x() * bc + b.x() * ca + c.x() * ab) / (ab + bc + ca) > 0.0) ++crossings;
  }
  return crossings % 2 == 1;
}

/// Sizes of the 6-connected components of a dense mask, and the component of each voxel (-1: none).
inline std::vector<long> components(const VolumeGrid& grid, const std::vector<std::uint8_t>& mask,
                                    std::vector<int>& of) {
  of.assign(mask.size(), -1);
  const long sx = 1, sy = grid.size.x(), sz = sy * grid.size.y();
  std::vector<long> sizes, stack;
  for (std::size_t start = 0; start < mask.size(); ++start) {
    if (!mask[start] || of[start] >= 0) continue;
    const int id = static_cast<int>(sizes.size());
    sizes.push_back(0);
    stack.assign(1, static_cast<long>(start));
    of[start] = id;
    while (!stack.empty()) {
      const long at = stack.back();
      stack.pop_back();
      ++sizes.back();
      const long x = at % sy, y = (at / sy) % grid.size.y(), z = at / sz;
      const auto push = [&](bool allowed, long next) {
        if (!allowed || !mask[static_cast<std::size_t>(next)] || of[static_cast<std::size_t>(next)] >= 0)
          return;
        of[static_cast<std::size_t>(next)] = id;
        stack.push_back(next);
      };
      push(x > 0, at - sx), push(x + 1 < grid.size.x(), at + sx);
      push(y > 0, at - sy), push(y + 1 < grid.size.y(), at + sy);
      push(z > 0, at - sz), push(z + 1 < grid.size.z(), at + sz);
    }
  }
  return sizes;
}

/// Points along the tubes with their radii, every 0.5 mm.
inline std::vector<std::pair<Eigen::Vector3d, double>> along(const VesselTree& vessels) {
  std::vector<std::pair<Eigen::Vector3d, double>> points;
  for (const auto& [a, b] : vessels.beams) {
    const Eigen::Vector3d pa = vessels.nodes.row(a).transpose(), pb = vessels.nodes.row(b).transpose();
    const int steps = static_cast<int>(std::ceil((pb - pa).norm() / 5e-4));
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      points.emplace_back(pa + t * (pb - pa), (1 - t) * vessels.radii[static_cast<std::size_t>(a)] +
                                                  t * vessels.radii[static_cast<std::size_t>(b)]);
    }
  }
  return points;
}

/// Least distance between the walls of two trees, metres, by sampling.
inline double wall_distance(const VesselTree& first, const VesselTree& second) {
  const auto a = along(first), b = along(second);
  double least = 1.0;
  for (const auto& [p, rp] : a)
    for (const auto& [q, rq] : b) {
      const double limit = least + rp + rq;
      const double square = (p - q).squaredNorm();
      if (square < limit * limit) least = std::sqrt(square) - rp - rq;
    }
  return least;
}

}  // namespace glisson::test
