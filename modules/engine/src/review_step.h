// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/atlas/transfer.h"
#include "glisson/engine/command.h"

namespace glisson::engine {

/// Of a command that changes one proposal and its landmark.
CommandTraits review_traits(std::string_view code);

/// What is proposed for a structure. @throws InputError nothing is.
const atlas::Proposal& require_proposed(const CaseState& state, atlas::Structure structure);

/// The case with this proposal in the place of the one of its structure, and with these points as its
/// landmark (CT frame, metres; none: no landmark), where registration knows the structure. Other landmarks
/// stay, unless they are of a former model; other proposals follow.
/// @param known how far the points may lie from where they are, as placed_deviations() had it; empty: as
///   atlas::landmark_deviations() says.
/// @throws InputError nothing is proposed for the structure.
Applied with_review(const CaseState& state, const atlas::Proposal& proposal, const Points& landmark,
                    const std::optional<Eigen::VectorXd>& known = {});

/// The evidence with a person's own margin, where there is one, in the place of the detected ridge.
/// @pre there is a model
atlas::Evidence with_own_ridge(const CaseState& state, atlas::Evidence evidence);
/// Proposals that nobody has decided follow those that are known (atlas::propose_again). @pre there are both,
/// model and proposals
void propose_others_again(CaseState& state);

/// The case after a decision on a proposal. What a person has placed by hand stays its structure's landmark
/// unless it was moved; where another place was accepted a note says so.
Applied with_decision(const CaseState& state, const atlas::Proposal& reviewed);

/// Of each of placed_points() where it comes from: as its proposal's review has left it; empty: it is not the
/// proposal's, or nothing is proposed.
std::vector<std::optional<atlas::Source>> proposed_sources(const CaseState& state,
                                                           atlas::Structure structure);

/// Whether one of placed_points() is where the proposal's review has left it.
bool rests_on_proposal(const CaseState& state, atlas::Structure structure);

/// Those of placed_points() that neither a proposal's review nor the model has brought: a person's own marks,
/// CT frame, metres. None of what may lie elsewhere (placed_deviations()): that was a guess.
/// @pre there is a model
PointsIn<CtFrame> marks_by_hand(const CaseState& state, atlas::Structure structure);
/// The case with these alone as a structure's landmark. @pre there is a model
CaseState with_marks_alone(const CaseState& state, atlas::Structure structure);

/// Whether a structure's landmark is what its proposal's review has left there, and nobody has placed or
/// taken away anything since. The model's own, which count where nothing is placed, are nobody's mark.
/// @pre there is a model
bool landmark_is_as_reviewed(const CaseState& state, atlas::Structure structure);

}  // namespace glisson::engine
