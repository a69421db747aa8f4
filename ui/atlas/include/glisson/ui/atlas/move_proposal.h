// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/atlas/transfer.h"
#include "glisson/geometry/ridge_way.h"

namespace glisson::ui {

/// Puts proposals elsewhere on a liver as a hand drags them.
class ProposalMover {
 public:
  /// @param liver a surface with triangles, CT frame, metres
  explicit ProposalMover(const TriangleMesh& liver);

  /// The point of a proposal that a hand takes when it presses at p (CT frame): the closest one.
  static Eigen::Index taken(const atlas::Proposal& proposal, const Eigen::Vector3d& p);
  /// What ReviewProposal takes after a drag: a single point lies there; the points of a contact go along as
  /// they are. Of the margin the point that was taken lies on the ridge near there, and its neighbours follow
  /// the ridge to where the course is kept; an end that is dragged takes the course with it. Of another line
  /// the neighbours follow less and less. All on the surface, CT frame.
  Points moved(const atlas::Proposal& proposal, Eigen::Index taken, const Eigen::Vector3d& to) const;

 private:
  /// CT frame.
  Points along_ridge(const Points& line, Eigen::Index taken, const Eigen::Vector3d& to) const;

  ClosestPointTree tree_;
  RidgeWays ridges_;
};

}  // namespace glisson::ui
