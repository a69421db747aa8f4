// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/atlas.h"

namespace glisson::atlas {

/// A structure as one member shows it.
struct Observation {
  std::string member;
  double weight = 1.0;
  Points points;          ///< on the mean liver, metres
  Eigen::VectorXd modes;  ///< of the member's shape, over their deviations
};

/// Mean, slopes on as many modes (0 to 3) as leave the least error on members left out, and the residuals of
/// members left out. @pre three observations at least
void observe(StructureStatistics& statistics, const std::vector<Observation>& observed);

/// Keeps of the residuals their mean square alone, and of the members their number. What the slopes explain
/// stays.
void sum_up(StructureStatistics& statistics);

/// The structure on the mean liver for a shape of these modes (over their deviations).
Points predicted(const StructureStatistics& statistics, const Eigen::VectorXd& modes);

/// As many vertices as belong to the area on average, those of the largest shares.
std::vector<int> area_vertices(const Eigen::VectorXd& share);

/// The affine map that carries the surroundings of a point from one surface onto the other, as far as they
/// tell it; else `otherwise`. @param reach standard deviation of the surroundings, metres
Eigen::Matrix3d local_map(const Points& from, const Points& onto, const Eigen::Vector3d& at, double reach,
                          const Eigen::Matrix3d& otherwise);

}  // namespace glisson::atlas
