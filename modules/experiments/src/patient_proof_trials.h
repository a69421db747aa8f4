// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "patient_proof.h"

namespace glisson::experiments {

/// Folders of the real CTs that are tried with this seed, whether they are there or not.
std::vector<std::string> tried_cts(std::uint64_t seed);
/// Names of folders of CTs ("ct_...") that are there and not tried, ascending.
std::vector<std::string> unused_cts(const std::filesystem::path& data, std::uint64_t seed);
/// The seed of the clicks on a pathology: whichever are tried, and whichever real CTs are there.
/// @param number of the pathology, from 0.
std::uint64_t clicks_on_pathology(std::uint64_t seed, std::size_t number);

/// Segments CTs that are as unlike as patients are, from the clicks of a layperson, and counts what comes of
/// it: ct_ircad1, the synthetic pathologies, and in the run of record (seed 1) ct_chaos3, which is kept for
/// validation. Figures "trial_...", one line of the table each. False: cancelled.
bool run_trials(const PatientProofOptions& options, PatientProof& proof, const RunContext& context);

}  // namespace glisson::experiments
