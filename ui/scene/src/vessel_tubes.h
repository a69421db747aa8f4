// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/patient/patient_model.h"

namespace glisson::scene {

/// Places along a vessel, close to each other: centre and radius. CT frame, metres.
using VesselCourse = std::vector<Eigen::Vector4d>;

/// Smooth courses along the centrelines of some trees of one structure, without thin distal branches: what is
/// under kThin in radius, with all that follows behind it. At a fork the widest branch goes on; the others
/// begin with a width of their own, not with the trunk's.
/// @param trees radii: one a node. @param triangles of the tubes around them, about, caps not counted.
std::vector<VesselCourse> vessel_courses(const std::vector<const VesselTree*>& trees, int triangles);

/// Closed tubes with round ends around courses, wound outwards. Where branches join they lie in each other.
/// @param courses of two places and more.
TriangleMesh tubes_around(const std::vector<VesselCourse>& courses);

}  // namespace glisson::scene
