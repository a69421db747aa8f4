// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/picture.h"

namespace glisson::stereo {

/// A closed polygon that the operator clicked on the left image; points in it get its feature. Pixel
/// coordinates of the distorted left image. Overlaps: notch over margin over surface.
struct Region {
  Feature feature = Feature::surface;
  std::vector<Eigen::Vector2d> polygon;
};
/// JSON {"image": "left", "frame": 0, "regions": [{"label": "surface", "polygon": [[x, y], ...]}, ...]}
struct Regions {
  int frame = 0;
  std::vector<Region> regions;
};
Regions read_regions(const std::filesystem::path& path);
void write_regions(const std::filesystem::path& path, const Regions& regions);

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
