// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "registration_proof.h"
#include "registration_stage.h"

/// @file
/// What a second cloud is worth that was seen from elsewhere, of which nobody knows from where.

namespace glisson::experiments {

/// One cloud alone, joined with another, and joined with one of another moment, when the organ was handled
/// otherwise: that must be told.
struct JoinedTrial {
  struct Found {
    double seen = 0.0;   ///< share of the surface
    double error = 0.0;  ///< mean over all nodes, metres; infinite: it failed
    bool refused = false;
    bool told = false;  ///< that the looks do not show one shape
  };
  std::string patient, handling;
  Found alone, joined, moved;
};

/// A fifth of the surface is seen, and another fifth, in part the same, after the laparoscope has gone round
/// by 35 degrees; in the third case the organ has been handled in the next way in between. One trial a
/// handling. @param number of the patient.
std::vector<JoinedTrial> try_joined(const RegistrationStage& stage, std::size_t number,
                                    const RegistrationProofOptions& options, const RunContext& context);

/// Adds one set's figures (prefixes "joined_", "moved_") and table. Errors "joined_alone_" and "joined_" are
/// over the "joined_compared" trials in which neither was refused; those of "moved_" over its own unrefused.
void sum_up(const std::vector<JoinedTrial>& trials, const std::string& set, RegistrationProof& proof);

}  // namespace glisson::experiments
