// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/patient_model.h"
#include "glisson/volume/image.h"

namespace glisson::insilico {

/// What is varied of the synthetic patient.
struct PatientOptions {
  std::uint64_t shape_seed = 1;               ///< one member of the population
  Eigen::Vector3d spacing_mm{1.5, 1.5, 2.0};  ///< of the CT
  double noise_hu = 12.0, blur_mm = 1.0;
  /// Between the samples of the surfaces; vessels and lesions are never coarser than 1 mm.
  double surface_spacing_mm = 1.5;
  /// @throws InputError naming the field that is out of its range.
  void validate() const;
};

/// A patient whose truth is known.
struct SyntheticPatient {
  Image ct;
  LabelMap truth;                      ///< on the CT's grid
  std::vector<NamedSurface> surfaces;  ///< liver, lesions, vena cava; CT frame, metres
  Landmarks landmarks;
  std::vector<VesselTree> trees;  ///< centrelines with radii, portal and hepatic
};
/// Draws the patient and scans it. The same options give the same bits; some seconds for the default CT.
/// @throws InputError options.
Cancellable<SyntheticPatient> make_patient(const PatientOptions& options, const RunContext& context);

}  // namespace glisson::insilico
