// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/bent_liver.h"

#include <cmath>

#include "glisson/geometry/closest_point_tree.h"

namespace glisson::ui {

atlas::Similarity patient_from_mean(const atlas::Atlas& atlas, const atlas::Transfer* transfer,
                                    const TriangleMesh& liver) {
  const Points& mean = atlas.shape.mean;
  if (transfer != nullptr && transfer->atlas == atlas.name && transfer->surface.rows() == mean.rows())
    return atlas::fit_similarity(mean, transfer->surface);
  atlas::Similarity onto;
  onto.scale = atlas::size_of(liver.vertices) / atlas::size_of(mean);
  onto.translation = (liver.vertices.colwise().mean() - onto.scale * mean.colwise().mean()).transpose();
  return onto;
}

BentLiver bent_liver(const atlas::Atlas& atlas, int mode, double deviations,
                     const atlas::Similarity& patient_from_mean) {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(atlas.shape.mode_count());
  b[mode] = deviations * std::sqrt(atlas.shape.variances[mode]);
  BentLiver liver{{patient_from_mean.apply(atlas.shape.instance(b)), atlas.triangles}, {}};
  const ClosestPointTree tree(liver.surface);
  for (const atlas::StructureStatistics& one : atlas.structures) {
    Points points = one.mean;
    if (mode < one.slopes.cols())
      points += deviations * Eigen::Map<const Points>(one.slopes.col(mode).data(), points.rows(), 3);
    points = patient_from_mean.apply(points);
    // Means of curves lie a little off the surface.
    for (Eigen::Index k = 0; k < points.rows(); ++k)
      points.row(k) = tree.closest(points.row(k).transpose()).point.transpose();
    liver.structures.emplace_back(one.structure, std::move(points));
  }
  return liver;
}

double share_of_variance(const atlas::Atlas& atlas, int mode) {
  return atlas.shape.total_variance > 0.0 ? atlas.shape.variances[mode] / atlas.shape.total_variance : 0.0;
}

}  // namespace glisson::ui
