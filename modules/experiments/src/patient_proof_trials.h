// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "patient_proof.h"

namespace glisson::experiments {

/// Segments CTs that are as unlike as patients are, from the clicks of a layperson, and counts what comes of
/// it: ct_ircad1, the synthetic pathologies, and in the run of record (seed 1) ct_chaos3, which is kept for
/// validation. Figures "trial_...", one line of the table each. False: cancelled.
bool run_trials(const PatientProofOptions& options, PatientProof& proof, const RunContext& context);

}  // namespace glisson::experiments
