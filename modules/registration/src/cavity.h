// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/core/frames.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"

namespace glisson::registration {

/// Where a laparoscope can stand: in the abdominal cavity. It lies before and below the liver; behind the
/// liver are spine and ribs, above it is the diaphragm. However it is rolled, that is known before anything
/// is seen.
class Cavity {
 public:
  /// @param model in the CT's frame, whose axes are the patient's (LPS).
  explicit Cavity(const PatientModel& model);
  /// Whether a camera can stand there: on the side of the plane through the organ's middle that faces
  /// forwards and downwards, or 20 degrees beyond it, since an operation turns the organ. Metres.
  bool holds(const Point<CtFrame>& eye) const;
  /// Whether the camera that saw a cloud (several: their middle) can have stood where a pose puts it.
  bool holds(const CameraFromCt& pose, const LabelledCloud& cloud) const;

 private:
  Eigen::Vector3d middle_;
};

}  // namespace glisson::registration
