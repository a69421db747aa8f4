// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/move_proposal.h"

#include <algorithm>
#include <cmath>

#include "glisson/atlas/member.h"

namespace glisson::ui {
namespace {

constexpr double kFollow = 0.02;       // metres along a line, standard deviation of what follows a drag
constexpr double kRenewed = 0.025;     // metres of a margin on either side that are laid again, at least
constexpr double kWayRenewed = 1.2;    // over how far the point was dragged
constexpr double kRidgeReach = 0.008;  // metres from the pointer within which a ridge is taken

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

/// The first point of a line, from `from` on, that is `way` (metres) away along it; else its end.
Eigen::Index beyond(const Points& line, Eigen::Index from, Eigen::Index step, double way) {
  Eigen::Index k = from;
  for (double gone = 0.0; gone < way && k + step >= 0 && k + step < line.rows(); k += step)
    gone += (line.row(k + step) - line.row(k)).norm();
  return k;
}

}  // namespace

ProposalMover::ProposalMover(const TriangleMesh& liver) : tree_(liver), ridges_(liver) {}

Eigen::Index ProposalMover::taken(const atlas::Proposal& proposal, const Eigen::Vector3d& p) {
  Eigen::Index closest = 0;
  (proposal.points.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff(&closest);
  return closest;
}

Points ProposalMover::along_ridge(const Points& line, Eigen::Index taken, const Eigen::Vector3d& to) const {
  const Eigen::Vector3d there = ridges_.onto_ridge(to, kRidgeReach);
  const double renewed = std::max(kRenewed, kWayRenewed * (there - line.row(taken).transpose()).norm());
  Points points = line;
  points.row(taken) = there.transpose();
  for (const Eigen::Index step : {Eigen::Index{-1}, Eigen::Index{1}}) {
    const Eigen::Index kept = beyond(line, taken, step, renewed);
    if (kept == taken) continue;
    const Eigen::Index count = std::abs(kept - taken) + 1;
    const Points way =
        atlas::resampled(ridges_.between(there, line.row(kept).transpose()), static_cast<int>(count));
    for (Eigen::Index k = 1; k + 1 < count; ++k)
      points.row(taken + step * k) = tree_.closest(way.row(k).transpose()).point.transpose();
  }
  return points;
}

Points ProposalMover::moved(const atlas::Proposal& proposal, Eigen::Index taken,
                            const Eigen::Vector3d& to) const {
  if (proposal.structure == atlas::Structure::anterior_margin) return along_ridge(proposal.points, taken, to);
  const bool is_area = atlas::is_area(proposal.structure);
  Points points = is_area ? proposal.area : proposal.points;
  const Eigen::RowVector3d wanted = tree_.closest(to).point.transpose();
  const Eigen::RowVector3d from = is_area ? points.colwise().mean() : Eigen::RowVector3d(points.row(taken));
  const Eigen::VectorXd share = is_area ? Eigen::VectorXd::Ones(points.rows()) : following(points, taken);
  for (Eigen::Index k = 0; k < points.rows(); ++k) {
    if (share[k] < 0.02) continue;
    const Eigen::Vector3d moved = (points.row(k) + share[k] * (wanted - from)).transpose();
    points.row(k) = tree_.closest(moved).point.transpose();
  }
  return points;
}

}  // namespace glisson::ui
