// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"

/// @file
/// Where else the organ may be. Several places may explain a cloud nearly as well: a person sees them and
/// chooses, none is taken at random.

namespace glisson::registration {

/// Mean distance of two shapes of one mesh from which on they are two places, metres.
inline constexpr double kRivalAway = 5e-3;

/// Those of the candidates that a person should look at: kRivalAway and more from `chosen` and from each
/// other, and not out of question. Neighbouring points share errors, so that odds exaggerate: only under 1 to
/// exp(10) a place is out of question, as for the mirror image. The most probable three, the first one first.
/// @param candidates probabilities beside the chosen one's.
std::vector<RegistrationRival> plausible_rivals(const PointsIn<CameraFrame>& chosen,
                                                std::vector<RegistrationRival> candidates);

/// Mean distance of the nodes from where the registration has put them, metres.
double distance_of(const RegistrationRival& rival, const Registration& registration);

/// A registration with one of its rivals in its place: the former place becomes a rival, forces are not known
/// there, nor what a look would tell, and the doubt rival_chosen (the probability in percent) says so. What
/// was refused stays refused; the new place is not examined. What is expected of errors stays: a person's
/// word is taken to exchange the odds of the two places, so that the one is as sure now as the other was.
/// @param which of registration.rivals. @throws InputError there is none of this number.
Registration choose_rival(const Registration& registration, std::size_t which, const PatientModel& model,
                          const LabelledCloud& cloud);

}  // namespace glisson::registration
