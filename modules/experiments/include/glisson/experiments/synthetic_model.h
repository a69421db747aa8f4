// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/run_context.h"
#include "glisson/insilico/patient.h"
#include "glisson/patient/patient_model.h"

namespace glisson::experiments {

/// A synthetic patient with the model that is built of its labels. CT frame, metres.
struct SyntheticModel {
  insilico::SyntheticPatient patient;
  /// What the labels tell: without notch and vena cava, which are among the patient's landmarks.
  PatientModel model;
};
/// A member of the population, scanned at 2.5 mm; its model has the usual size. Empty: cancelled.
Cancellable<SyntheticModel> synthetic_model(std::uint64_t shape_seed, const RunContext& context);

/// What a theatre is built of: true surfaces, vessels and landmarks; no mesh.
PatientModel shown_in_theatre(insilico::SyntheticPatient patient);

}  // namespace glisson::experiments
