// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/registration/operation_prior.h"
#include "phantom.h"

namespace glisson::phantom {

/// The phantom as it lies in a patient: its dome, whose rim is seen, to the front (-y of the CT is anterior).
inline PatientModel lying(int nx, int ny, int nz) {
  PatientModel model = phantom::model(nx, ny, nz);
  const auto turned = [](Points& points) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      points.row(i) = Eigen::RowVector3d(points(i, 0), -points(i, 2), points(i, 1));
  };
  for (Points* points : {&model.mesh.vertices, &model.surface.mesh.vertices, &model.landmarks.anterior_margin,
                         &model.landmarks.umbilical_notch, &model.landmarks.vena_cava})
    turned(*points);
  return model;
}

inline CameraFromCt lying_view() {
  CameraFromCt back;  // undoes lying(), then looks as the phantom's camera does
  back.rotation << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  CameraFromCt pose = view();
  pose.rotation = pose.rotation * back.rotation;
  return pose;
}

inline registration::OperationPrior simulated(const PatientModel& model, int operations, std::uint64_t seed) {
  registration::OperationOptions options;
  options.operations = operations;
  // The phantom is thinner than a liver: it bends more under the same loads.
  options.gravity = 1.4;
  options.gas_pa = 120.0;
  options.bed_m = 0.009;
  return simulate_operations(model, options, RunContext({}, {}, seed)).value();
}

}  // namespace glisson::phantom
