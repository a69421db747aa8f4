// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/experiments/aims.h"

/// @file
/// How far off a registration is where nobody looks, and whether it says so: livers handled in ways that its
/// prior does not know, and clouds that are not of the patient.

namespace glisson::experiments {

/// What is measured.
struct RegistrationProofOptions {
  std::filesystem::path data;  ///< real livers; those that are absent are left out
  bool development = true, validation = true;
  std::uint64_t seed = 1;
  std::vector<double> shares{0.1, 0.2, 0.3, 0.5};  ///< of the surface that is seen
  std::size_t handlings = 10;                      ///< of insilico::kHandlings, the first ones
  bool rivals = true;                              ///< the paper's method too
  /// Instead of all that: whether the look that a registration asks for helps.
  bool looks_alone = false;
  std::string only;  ///< patients whose name contains this; empty: all
  int patients = 0;  ///< of either set, the first ones; 0: all
  int threads = 2;   ///< 1 or 2, patient by patient
  /// Registrations that this folder's registration_SEED.csv holds, of a run that was cut short, are taken
  /// from there. Empty: none.
  std::filesystem::path former;
  /// Few trials: to see whether it runs.
  static RegistrationProofOptions quick();
  /// @throws InputError naming the option.
  void validate() const;
};

/// How far off registrations were, and whether they said so.
struct RegistrationProof {
  /// Keys begin with "registration_development_" or "registration_validation_".
  /// "30_mean_mm" (30 % seen) and the other methods' means are over the clouds whose registration gave a
  /// result; "30_failed" is the number of those without one, and "30_all_mean_mm" is infinite where there is
  /// such a one.
  /// "others_..." are handlings that are tried with one share alone; they are not among "30_...".
  /// "expected_correlation_at_best" is what "expected_correlation" would be if every expectation were right.
  Figures figures;
  std::vector<std::string> table;   ///< of both sets, validation first
  std::vector<std::string> absent;  ///< real data that were left out
};

/// Keeps `registration_SEED.csv`, a line each registration, in `folder`, which exists: written anew after
/// each. An error is the largest over three lesions deep in the liver, far from each other. Empty: cancelled.
/// @throws Error.
Cancellable<RegistrationProof> prove_registration(const RegistrationProofOptions& options,
                                                  const std::filesystem::path& folder,
                                                  const RunContext& context);

/// What its figures should be.
const std::vector<Aim>& registration_aims();

}  // namespace glisson::experiments
