// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/experiments/aims.h"
#include "glisson/insilico/patient.h"

/// @file
/// From the CT to the model, measured: on a real CT against an expert's labels, and on the synthetic patient
/// against its truth.

namespace glisson::experiments {

/// What is measured.
struct PatientProofOptions {
  /// The folder with ct_ircad1 (PATIENT_DICOM.tar.gz, 3Dircadb0101Labeled.vti); absent: the synthetic patient
  /// only.
  std::filesystem::path data;
  /// Clicks and label codes of the real patient: 3dircadb1_seeds.json, 3dircadb1_codes.json.
  std::filesystem::path clicks;
  int strokes = 20;                  ///< of the scripted edit of the vessels
  bool synthetic = true;             ///< the patient in silico too
  insilico::PatientOptions patient;  ///< that one; its shape's seed is `seed`
  std::string only;                  ///< trials in silico whose name contains this; empty: all
  std::uint64_t seed = 1;

  /// @throws InputError naming the option.
  void validate() const;
};

/// What was measured, from the CT to the model.
struct PatientProof {
  /// Keys begin with "real_" or "synthetic_": Dice coefficients, seconds of each stage, figures of the model;
  /// with "trial_": how the liver's segmentation carries over.
  Figures figures;
  std::vector<std::string> notes;
  std::vector<std::string> absent;  ///< real data that were left out
  std::vector<std::string> unused;  ///< real CTs that are there, and that no trial uses
  std::vector<std::string> table;   ///< the trials, one line each; the last column is the time in seconds
};
/// What prove_patient() is measured against.
const std::vector<Aim>& patient_aims();

/// Runs import, segmentation, the scripted edit and two models (the paper's size, and 10,000 tetrahedra) by
/// engine commands that read files only; the expert's labels are read by the simulated hand that draws the
/// strokes, and by the comparisons. Then segments CTs as unlike as patients are from a layperson's clicks
/// (see insilico/pathology.h, layperson.h). Cases and scripts are left in `folder`, which exists. Empty:
/// cancelled. @throws Error.
Cancellable<PatientProof> prove_patient(const PatientProofOptions& options,
                                        const std::filesystem::path& folder, const RunContext& context);

}  // namespace glisson::experiments
