// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/core/run_context.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/findings.h"
#include "glisson/registration/pairs.h"
#include "shape_fits.h"

namespace glisson::registration {

/// Deviation of points from a smooth surface: the rms residual of a paraboloid through each point's
/// neighbours, median over the points. @pre neighbours: 8 and more are taken where there are as many.
/// Cancelled: 0.
double roughness_of(const PreparedCloud& cloud, const RunContext& context = {});

/// The cloud as a mirror would show it: x changes its sign.
LabelledCloud mirrored(const LabelledCloud& cloud);

/// What is examined.
struct Examined {
  const PatientModel& model;
  const LabelledCloud& cloud;
  const Registration& registration;
  const ShapeFits* shapes = nullptr;  ///< null: there was no prior
  const ErrorModel& error;
  /// Whether the cloud's frame is that of the camera that saw it. False: what needs to know where it stood is
  /// not asked (hidden and, of a cloud without normals of its own, turned: not a number).
  bool in_cameras_frame = true;
};
/// All but mirror_odds. @throws InputError the cloud's as in prepare_cloud.
Cancellable<Findings> examine(const Examined& examined, const RunContext& context = {});

}  // namespace glisson::registration
