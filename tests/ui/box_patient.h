// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/camera.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/patient_model.h"

namespace glisson {

/// Six tetrahedra a cell around the cell's main diagonal.
TetMesh block_mesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int n);
/// A closed ball of n rings.
TriangleMesh ball_mesh(const Eigen::Vector3d& centre, double radius, int n);
/// A block of "liver" of 120 x 80 x 50 mm around the origin with a portal branch, a hepatic one and a lesion.
PatientModel box_patient();
/// Off-centre principal point, two focal lengths, skew, strong barrel distortion.
/// @param scale of the picture's 640 x 360 pixels.
Camera laparoscope(double scale = 1.0);

}  // namespace glisson
