// SPDX-License-Identifier: GPL-3.0-or-later
#include "farthest_first.h"

#include <limits>

namespace glisson::registration {

Spread farthest_first(const Points& points, double spacing, Eigen::Index first) {
  Spread spread;
  if (points.rows() == 0) return spread;
  Eigen::VectorXd distance =
      Eigen::VectorXd::Constant(points.rows(), std::numeric_limits<double>::infinity());
  spread.nearest.assign(static_cast<std::size_t>(points.rows()), 0);
  Eigen::Index next = first;
  do {
    const Eigen::VectorXd fresh = (points.rowwise() - points.row(next)).rowwise().squaredNorm();
    for (Eigen::Index i = 0; i < fresh.size(); ++i)
      if (fresh[i] < distance[i])
        distance[i] = fresh[i], spread.nearest[static_cast<std::size_t>(i)] = spread.chosen.size();
    spread.chosen.push_back(next);
  } while (distance.maxCoeff(&next) > spacing * spacing);
  return spread;
}

}  // namespace glisson::registration
