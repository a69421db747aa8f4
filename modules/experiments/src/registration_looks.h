// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "registration_proof.h"
#include "registration_stage.h"

/// @file
/// Whether the look that a registration asks for helps: the place is shown to it, and it registers again.

namespace glisson::experiments {

/// The lesion that the registration knows least, before and after one more look. Metres.
struct LookTrial {
  std::string handling;
  double expected = 0.0, promised = 0.0;  ///< its expected error, and what the look is said to leave
  double error = 0.0;                     ///< that it has
  double after = 0.0, after_other = 0.0;  ///< after the best look; after one at a place drawn from all others
  std::vector<std::string> doubts;        ///< of the registration before
};

/// A fifth of the surface is seen, then also what faces the place within 30 mm: the patient's own surface
/// where the handling has carried it, with 1 mm of noise. One trial a handling; none where no look is said to
/// help, or a registration is refused. @param number of the patient.
std::vector<LookTrial> try_looks(const RegistrationStage& stage, std::size_t number,
                                 const RegistrationProofOptions& options, const RunContext& context);

/// Adds one set's figures (medians; prefix "looks_") and table.
void sum_up(const std::vector<LookTrial>& trials, const std::string& set, RegistrationProof& proof);

}  // namespace glisson::experiments
