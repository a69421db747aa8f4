// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/synthetic_model.h"

#include <utility>

#include "glisson/model/build.h"

namespace glisson::experiments {

Cancellable<SyntheticModel> synthetic_model(std::uint64_t shape_seed, const RunContext& context) {
  insilico::PatientOptions options;
  options.shape_seed = shape_seed;
  options.spacing_mm = {2.5, 2.5, 2.5};
  options.surface_spacing_mm = 2.0;
  auto patient = insilico::make_patient(options, context.part(0.0, 0.4));
  if (!patient) return std::nullopt;
  auto built = model::build_from_labels(patient->truth, {}, context.part(0.4, 1.0));
  if (!built) return std::nullopt;
  return SyntheticModel{std::move(*patient), std::move(built->model)};
}

PatientModel shown_in_theatre(insilico::SyntheticPatient patient) {
  PatientModel shown;
  shown.surfaces = std::move(patient.surfaces);
  shown.vessels = std::move(patient.trees);
  shown.landmarks = std::move(patient.landmarks);
  return shown;
}

}  // namespace glisson::experiments
