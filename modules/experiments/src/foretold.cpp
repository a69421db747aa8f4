// SPDX-License-Identifier: GPL-3.0-or-later
#include "foretold.h"

#include <Eigen/LU>

#include "glisson/geometry/distance.h"

namespace glisson::experiments {
using namespace atlas;

LeftOut judged(const Transfer& made, const Member& member) {
  LeftOut liver;
  liver.name = member.name;
  liver.mean_distance = made.mean_distance;
  liver.max_distance = made.max_distance;
  liver.unusual = made.unusual;
  liver.doubts = made.doubts;
  for (const Proposal& one : made.proposals) {
    const auto raw = member.structures.find(one.structure);
    if (raw == member.structures.end()) continue;
    const auto notch = member.structures.find(Structure::umbilical_notch);
    const Points truth = ordered_points(one.structure, raw->second, Eigen::Matrix3d::Identity(),
                                        notch == member.structures.end() ? Points(0, 3) : notch->second);
    if (truth.rows() == 0) continue;
    const Eigen::VectorXd errors = (truth - one.points).rowwise().norm();
    const SetDistance area = is_area(one.structure) ? set_distance(one.area, raw->second) : SetDistance{};
    LeftOutStructure found{errors.mean(),   errors.maxCoeff(), area.mean, 0, static_cast<int>(errors.size()),
                           one.deviation(), area.largest};
    for (Eigen::Index k = 0; k < truth.rows(); ++k) {
      const Eigen::Vector3d off = (truth.row(k) - one.points.row(k)).transpose();
      if (off.dot(one.covariances[static_cast<std::size_t>(k)].inverse() * off) <= kEllipsoid95)
        ++found.inside;
    }
    liver.structures[one.structure] = found;
  }
  return liver;
}

Cancellable<LeftOut> foretold(const Atlas& known, const Member& member, const RunContext& context) {
  const auto made = transfer(known, member.liver, {}, context.quiet());
  if (!made) return {};
  return judged(*made, member);
}

}  // namespace glisson::experiments
