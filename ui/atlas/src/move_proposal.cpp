// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/move_proposal.h"

#include <cmath>

#include "glisson/geometry/closest_point_tree.h"

namespace glisson::ui {
namespace {

constexpr double kFollow = 0.02;  // metres along a line, standard deviation of what follows a drag

/// How much each point of a line follows the one that is dragged.
Eigen::VectorXd following(const Points& line, Eigen::Index dragged) {
  Eigen::VectorXd share(line.rows());
  for (const Eigen::Index step : {Eigen::Index{-1}, Eigen::Index{1}}) {
    double way = 0.0;
    for (Eigen::Index k = dragged; k >= 0 && k < line.rows(); k += step) {
      share[k] = std::exp(-0.5 * way * way / (kFollow * kFollow));
      if (k + step >= 0 && k + step < line.rows()) way += (line.row(k + step) - line.row(k)).norm();
    }
  }
  return share;
}

}  // namespace

Points moved_points(const atlas::Proposal& proposal, const Eigen::Vector3d& to, const TriangleMesh& liver) {
  const bool is_area = atlas::is_area(proposal.structure);
  Points points = is_area ? proposal.area : proposal.points;
  const ClosestPointTree tree(liver);
  const Eigen::RowVector3d wanted = tree.closest(to).point.transpose();
  Eigen::Index closest = 0;
  (points.rowwise() - wanted).rowwise().squaredNorm().minCoeff(&closest);
  const Eigen::RowVector3d from = is_area ? points.colwise().mean() : Eigen::RowVector3d(points.row(closest));
  const Eigen::VectorXd share = is_area ? Eigen::VectorXd::Ones(points.rows()) : following(points, closest);
  for (Eigen::Index k = 0; k < points.rows(); ++k) {
    if (share[k] < 0.02) continue;
    const Eigen::Vector3d moved = (points.row(k) + share[k] * (wanted - from)).transpose();
    points.row(k) = tree.closest(moved).point.transpose();
  }
  return points;
}

}  // namespace glisson::ui
