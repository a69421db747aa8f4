// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "glisson/atlas/transfer.h"

/// @file
/// What a person's word makes of a proposal, and which landmark the registration may take from it.

namespace glisson::atlas {

/// The proposal after a decision. A point that was moved is the person's; one that merely followed the
/// dragged one keeps its source and its covariance.
/// @param moved read where `decision` is moved (CT frame, metres): M x 3, as many points as the proposal has;
///   for areas the points of the contact.
/// @throws InputError another number of points; fewer than 3 of a contact.
Proposal reviewed(const Proposal& proposal, Decision decision, const PointsIn<CtFrame>& moved);

/// What a review leaves as the landmark of a proposal's structure, by what was decided: points in the CT's
/// frame, metres; none where it is not accepted, or shows too little.
PointsIn<CtFrame> landmark_left_by(const Proposal& proposal);

/// Of each point of a landmark where it comes from, as a proposal's review has left it; empty: it is none of
/// these, so that somebody has placed it otherwise.
/// @param landmark M x 3, CT frame, metres. @return M of them.
std::vector<std::optional<Source>> landmark_sources(const Proposal& proposal,
                                                    const PointsIn<CtFrame>& landmark);

/// Of each point of a landmark its standard deviation across its course (of a single point: in any
/// direction), metres. 0 where a person has placed it or the image shows it, and for points that are not the
/// proposal's.
/// @param landmark M x 3, CT frame, metres. @return M numbers.
Eigen::VectorXd landmark_deviations(const Proposal& proposal, const PointsIn<CtFrame>& landmark);

}  // namespace glisson::atlas
