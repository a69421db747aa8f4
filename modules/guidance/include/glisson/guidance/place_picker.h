// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glisson/geometry/camera.h"
#include "glisson/patient/correction.h"
#include "glisson/patient/patient_model.h"

namespace glisson::guidance {

/// A place of the model, and where a picture shows it.
struct PickedPlace {
  CorrectedFeature feature = CorrectedFeature::surface;
  Eigen::Vector3d place_in_ct = Eigen::Vector3d::Zero();  ///< metres
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();        ///< of the view
  /// Of a hand that drags it there, standard deviation: a Correction's own in pictures up to 960 pixels wide;
  /// in wider ones the same way on a screen has more pixels.
  double sigma_px = Correction().sigma_px;
};

/// What of the drawn model lies under a pixel. What a person can find again in the picture comes first: the
/// notch, then the anterior margin, then a vessel that runs within 3 mm of the surface on the camera's side,
/// each within `reach_px`; otherwise the surface along the pixel's ray.
/// @param nodes_in_camera of the model's mesh, left camera's frame, metres. @pre one row a node.
/// @param reach_px pixels; negative: 1.5 % of the picture's width.
/// @return empty: the pixel is beside the model.
std::optional<PickedPlace> pick_place(const PatientModel& model, const Points& nodes_in_camera,
                                      const StereoRig& rig, StereoView view, const Eigen::Vector2d& pixel,
                                      double reach_px = -1.0);

/// Where a view shows a place of the model. @param place_in_ct metres. @param nodes_in_camera as above.
/// @return empty: behind the camera.
std::optional<Eigen::Vector2d> pixel_of(const PatientModel& model, const Points& nodes_in_camera,
                                        const StereoRig& rig, StereoView view,
                                        const Eigen::Vector3d& place_in_ct);

}  // namespace glisson::guidance
