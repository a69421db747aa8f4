// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/picture.h"
#include "glisson/stereo/regions.h"

namespace glisson::stereo {

struct ReconstructOptions {
  int features = 3000;  ///< wanted per image
  double ratio = 0.8;   ///< Lowe's
  double epipolar_px = 1.5, reprojection_px = 1.0;
  bool smooth = true;  ///< moving least squares
  void validate() const;
};
struct ReconstructReport {
  int features_left = 0, features_right = 0, matches = 0, points = 0;
  double density_per_cm2 = 0.0;
};
struct Reconstructed {
  LabelledCloud cloud;
  ReconstructReport report;
};

/// Stereo pair to labelled cloud: SURF, ratio and cross check, epipolar gate, triangulation, reprojection
/// gate, moving least squares with normals. With regions only what lies in one is kept.
/// @param mask empty, or one byte a pixel of the left image: non-zero is to be used.
/// @throws InputError images of another size than the calibration's, left and right swapped, too few points.
Cancellable<Reconstructed> reconstruct(const Picture& left, const Picture& right, const StereoRig& rig,
                                       const Picture& mask, const Regions& regions,
                                       const ReconstructOptions& options, const RunContext& context);

}  // namespace glisson::stereo
