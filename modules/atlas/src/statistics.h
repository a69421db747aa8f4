// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"

namespace glisson::atlas {

/// Weight of an even covariance beside the residuals', in members: few residuals leave directions without
/// any.
inline constexpr double kEvenMembers = 2.0;

/// A structure as one member shows it.
struct Observation {
  std::string member;
  double weight = 1.0;
  Points points;          ///< on the mean liver, metres
  Eigen::VectorXd modes;  ///< of the member's shape, over their deviations
};

/// How many modes (0 to 3) leave the least error on members left out: of each structure the squared residuals
/// over those without modes, summed. @pre three observations of each at least
int modes_for(const std::vector<std::vector<Observation>>& structures);
/// Mean, slopes on so many modes, and the residuals of members left out. @pre three observations at least
void observe(StructureStatistics& statistics, const std::vector<Observation>& observed, int modes);

/// How far the structure's middle lies from its mean, rms over the members, metres.
double spread_of(const std::vector<Observation>& observed);
/// By how much the modes move a coordinate, rms, metres.
double slope_size(const StructureStatistics& statistics);

/// What a point of another structure tells of this one: their joint covariance over the members' residuals,
/// with an even one of kEvenMembers' weight as in covariance(), conditioned on that point; and of its word
/// the share that leaves the least on members left out (stacked regressions; Breiman 1996). Empty: too few
/// members show both, or it tells nothing.
/// @param without a member that has no part in it; empty: none.
std::optional<Dependence> dependence(const StructureStatistics& of, const StructureStatistics& on, int point,
                                     const std::string& without = {});
/// Gives each of these, of each of the others, the point that tells most of it. What has an added deviation
/// gets and gives none: its members do not show how patients differ, still less how structures do together.
void learn_dependences(const std::vector<StructureStatistics*>& structures);

/// Keeps of the residuals their mean square alone, and of the members their number. What the slopes explain
/// and what others tell stays.
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
