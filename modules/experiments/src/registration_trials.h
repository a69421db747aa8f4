// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/experiments/registration_proof.h"
#include "registration_stage.h"

namespace glisson::experiments {

/// One registration, judged with the truth at hand. Lengths in metres.
struct RegistrationTrial {
  std::string patient;
  ProofSet set = ProofSet::development;
  std::string handling;
  double share = 0.0;
  RegistrationFault fault = RegistrationFault::none;
  double mean = 0.0;             ///< error of the nodes; infinite: the cloud does not show the organ
  std::vector<double> lesions;   ///< errors of the lesions, likewise
  std::vector<double> expected;  ///< what the registration itself expects of them; empty: it does not say
  std::vector<char> covered;     ///< whether the lesion's 95 % ellipsoid holds the truth
  double rigid_mean = 0.0;       ///< left by the best rigid alignment of true correspondences
  double paper_mean = 0.0;       ///< of the paper's method
  double seconds = 0.0;
  bool refused = false;
  std::vector<std::string> doubts;
  Figures figures;  ///< evidence

  double worst_lesion() const;
  bool doubted() const { return refused || !doubts.empty(); }
};

/// All trials of one patient. @param number of it. Cut short when cancelled.
std::vector<RegistrationTrial> run_trials(const RegistrationStage& stage, const RegistrationStage& other,
                                          const RegistrationProofOptions& options, std::size_t number,
                                          const RunContext& context);

std::string csv_of(const std::vector<RegistrationTrial>& trials);
/// Adds one set's figures and table.
void sum_up(const std::vector<RegistrationTrial>& trials, ProofSet set, RegistrationProof& proof);

}  // namespace glisson::experiments
