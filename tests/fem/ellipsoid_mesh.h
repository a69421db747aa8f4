// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "block_mesh.h"

namespace glisson::fem_test {

/// A liver-sized body: the cells of a grid whose centres lie in an ellipsoid of 200 x 150 x 100 mm, six
/// tetrahedra each. `across`: cells along the longest axis (10 gives about 2,000 tetrahedra, 17.. 10,000).
inline TetMesh ellipsoid_mesh(int across) {
  const Eigen::Vector3d size(0.2, 0.15, 0.1);
  const Eigen::Vector3i cells(across, std::max(1, across * 3 / 4), std::max(1, across / 2));
  const TetMesh block = block_mesh(cells, size);
  TetMesh mesh;
  std::vector<int> kept;
  for (int t = 0; t < block.tetrahedron_count(); t += 6) {
    // The first and last node of a cell's first tetrahedron are its opposite corners.
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (int k = 0; k < 6; ++k)
      for (int i = 0; i < 4; ++i) centre += block.vertex(block.tetrahedra(t + k, i)) / 24.0;
    if ((2.0 * centre.cwiseQuotient(size) - Eigen::Vector3d::Ones()).norm() < 1.0)
      for (int k = 0; k < 6; ++k) kept.push_back(t + k);
  }
  std::map<int, int> new_of_old;
  for (const int t : kept)
    for (int i = 0; i < 4; ++i) new_of_old.try_emplace(block.tetrahedra(t, i), 0);
  mesh.vertices.resize(static_cast<Eigen::Index>(new_of_old.size()), 3);
  int next = 0;
  for (auto& [old, fresh] : new_of_old) {
    fresh = next++;
    mesh.vertices.row(fresh) = block.vertices.row(old);
  }
  mesh.tetrahedra.resize(static_cast<Eigen::Index>(kept.size()), 4);
  for (std::size_t t = 0; t < kept.size(); ++t)
    for (int i = 0; i < 4; ++i)
      mesh.tetrahedra(static_cast<Eigen::Index>(t), i) = new_of_old[block.tetrahedra(kept[t], i)];
  return mesh;
}

/// `count` beams of 5 mm in vessels through the ellipsoid, thick near one end as a portal tree is.
inline std::vector<VesselTree> ellipsoid_vessels(int count) {
  std::vector<VesselTree> vessels;
  const Eigen::Vector3d root(0.03, 0.075, 0.05);
  for (unsigned seed = 0; count > 0; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const Eigen::Vector3d to{0.15 + 0.03 * uniform(random), 0.075 + 0.04 * uniform(random),
                             0.05 + 0.025 * uniform(random)};
    const int beams = std::min(count, static_cast<int>((to - root).norm() / 0.005));
    vessels.push_back(straight_vessel(root, to, beams, seed == 0 ? 0.005 : 0.002));
    count -= beams;
  }
  return vessels;
}

}  // namespace glisson::fem_test
