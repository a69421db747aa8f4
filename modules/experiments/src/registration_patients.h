// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/patient_model.h"

namespace glisson::experiments {

/// Limits are set on development alone; validation is looked at, and the look is logged in the README.
enum class ProofSet { development, validation };

/// Who is registered in the proof, and on which side. The one list of it.
struct ProofPatient {
  enum class Kind { synthetic, labels, surfaces };
  const char* name;
  ProofSet set;
  Kind kind;
  int number;        ///< seed of a synthetic one, number of a label map
  const char* path;  ///< below the data folder
};
const std::vector<ProofPatient>& proof_patients();

/// What the theatre shows of a patient, and the model that is registered.
struct ProofModel {
  PatientModel shown, model;
};
/// @throws Error. Empty: cancelled.
Cancellable<ProofModel> load(const ProofPatient& patient, const std::filesystem::path& data,
                             const RunContext& context);

}  // namespace glisson::experiments
