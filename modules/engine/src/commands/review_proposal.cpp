// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/review_proposal.h"

#include <algorithm>
#include <string>
#include <vector>

#include "../proposal_landmark.h"
#include "../review_step.h"
#include "glisson/core/error.h"
#include "glisson/engine/parts/proposals.h"
#include "seen.h"

namespace glisson::engine {
namespace {
using atlas::Decision;
using atlas::Proposal;
using atlas::Source;
using atlas::Structure;

constexpr double kHandDeviation = 0.003;  // metres, of a point that a person placed
constexpr double kMoved = 0.0005;         // metres, from which on a point was moved
/// What follows a dragged point by less than this share of its way is still what it was.
constexpr double kCarried = 0.6;

void move(Proposal& proposal, const Points& to) {
  const Eigen::Matrix3d by_hand = kHandDeviation * kHandDeviation * Eigen::Matrix3d::Identity();
  if (atlas::is_area(proposal.structure)) {
    if (to.rows() < 3)
      throw InputError("ReviewProposal", "moved", "has fewer than 3 points",
                       "Give the points of the contact");
    proposal.area = to;
    proposal.points =
        (proposal.points.rowwise() - proposal.points.colwise().mean()).rowwise() + to.colwise().mean();
    for (Eigen::Index k = 0; k < proposal.points.rows(); ++k) {  // its course lies on the contact
      Eigen::Index closest = 0;
      (to.rowwise() - proposal.points.row(k)).rowwise().squaredNorm().minCoeff(&closest);
      proposal.points.row(k) = to.row(closest);
    }
    std::fill(proposal.sources.begin(), proposal.sources.end(), Source::person);
    std::fill(proposal.covariances.begin(), proposal.covariances.end(), by_hand);
  } else {
    if (to.rows() != proposal.points.rows())
      throw InputError("ReviewProposal", "moved", "has " + std::to_string(to.rows()) + " points",
                       "Give as many as are proposed: " + std::to_string(proposal.points.rows()));
    const Eigen::VectorXd way = (to - proposal.points).rowwise().norm();
    const double least = std::max(kMoved, kCarried * way.maxCoeff());
    for (Eigen::Index k = 0; k < to.rows(); ++k) {
      if (way[k] < least) continue;
      proposal.sources[static_cast<std::size_t>(k)] = Source::person;
      proposal.covariances[static_cast<std::size_t>(k)] = by_hand;
    }
    proposal.points = to;
  }
}

}  // namespace

CommandTraits ReviewProposal::traits() const { return review_traits("review_proposal"); }

Cancellable<Applied> ReviewProposal::apply(const CaseState& state, const RunContext&) const {
  require_seen(state, part::proposals, seen);
  const Proposal* proposed = proposal_of(state, structure);
  if (proposed == nullptr)
    throw InputError("ReviewProposal", atlas::structure_code(structure), "is not proposed",
                     "Let an atlas that knows it propose it first");
  Proposal reviewed = *proposed;
  if (decision == Decision::moved) move(reviewed, moved);
  reviewed.decision = decision;
  return with_review(state, reviewed, landmark_left_by(reviewed));
}

}  // namespace glisson::engine
