// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/error_model.h"

namespace glisson::registration {

inline constexpr int kForksTold = 5;         ///< of a tree, at most
inline constexpr double kForksApart = 5e-3;  ///< m: what is nearer to a larger fork is part of it

/// Where a vessel tree divides.
struct VesselFork {
  Label tree = 0;
  double radius = 0.0;                              ///< of the vessel there, m
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< CT frame, m
};
/// The largest forks of portal vein and of hepatic veins, each tree's largest first; of those of one
/// structure in several pieces as of one.
std::vector<VesselFork> largest_forks(const std::vector<VesselTree>& vessels, int most = kForksTold);

/// Where a registration has put them, and how far off they may be.
std::vector<ForkSpread> forks_of(const PatientModel& model, const Registration& registration,
                                 const ErrorModel& error);
/// Turns what is known of a registration's error (lesions, forks, nodes; camera frame) as the organ turns
/// from one place to another: the rotation of the rigid motion between them that fits best. @pre as many
/// nodes.
void turn_errors(Registration& registration, const Points& from_in_camera, const Points& to_in_camera);
/// A registration of an organ that has moved since, in the camera's frame of now: what is known of its error
/// has turned with it. Where else it might have been, which look would have helped and where forces acted
/// belongs to the registered moment and is left out. @param nodes_in_camera metres.
Registration carried_to(const PatientModel& model, Registration registration, const Points& nodes_in_camera);
/// The forks of a registration whose nodes have come to lie elsewhere, there.
void place_forks(const PatientModel& model, Registration& registration);

}  // namespace glisson::registration
