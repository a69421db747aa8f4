// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "glisson/engine/case_state.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/stereo/density.h"
#include "glisson/stereo/reconstruct.h"

namespace glisson::engine {

/// The points of a whole stereo pair, and what they were made of: other regions need no others.
struct PairPoints {
  std::shared_ptr<const StereoInput> frame;  ///< null: one that a case of before knew
  std::shared_ptr<const StereoRig> rig;      ///< the same
  stereo::ReconstructOptions options;
  std::shared_ptr<const stereo::Reconstructed> whole;  ///< made without regions
  double area_cm2 = 0.0;            ///< of the surface that the cloud stands for: within the regions, if any
  double density_per_cm2 = 0.0;     ///< of the cloud
  stereo::DensityMap density;       ///< where in the left picture points are missing
  std::string frame_identity = {};  ///< stereo::frame_identity of the pair
};

namespace part {
/// The labelled cloud that the model is registered to.
extern const PartOf<LabelledCloud> cloud;
/// Comes with a reconstructed cloud.
extern const PartOf<PairPoints> points;
}  // namespace part

}  // namespace glisson::engine
