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
inline constexpr double kRivalAway = 10e-3;
/// Whether two shapes of one mesh are two answers and not nearly the same one.
bool are_rivals(const PointsIn<CameraFrame>& a, const PointsIn<CameraFrame>& b);

/// Another fit of one cloud.
struct OtherFit {
  PointsIn<CameraFrame> nodes_in_camera;
  /// Logarithm of its odds against the chosen fit, as if the points' errors were as independent as
  /// `information` says.
  double log_odds = 0.0;
};
/// By how much the log odds of two fits are to be divided. They count the points of each place of 25 mm as
/// this many independent ones; but the model's own error (segmentation, law, supports) is the same all over
/// such a place, so it should count as one. At least 1.
/// @param information of a point, as ShapeFitOptions::information.
double votes_of_a_place(double information);
/// Each place where a fit has ended, kRivalAway and more from `chosen` and from all better ones, with the
/// probability that the organ is there; the most probable first.
/// @param votes log odds are divided by it, see votes_of_a_place().
std::vector<RegistrationRival> weigh_places(const PointsIn<CameraFrame>& chosen, std::vector<OtherFit> fits,
                                            double votes);
/// Fits that ended nearer than that to `chosen`, and half a millimetre and more from it and from all better
/// ones, with the probability of each among these and the chosen one: their spread is a part of the error
/// (law of total variance).
std::vector<RegistrationRival> weigh_near(const PointsIn<CameraFrame>& chosen, std::vector<OtherFit> fits,
                                          double votes);
/// Probability that the organ is more than 20 mm away from where it was put.
double elsewhere(const PointsIn<CameraFrame>& chosen, const std::vector<RegistrationRival>& places);
/// Those that a person should look at: of 1 % and more, three at most.
std::vector<RegistrationRival> plausible_rivals(std::vector<RegistrationRival> places);

/// Mean distance of the nodes from where the registration has put them, metres.
double distance_of(const RegistrationRival& rival, const Registration& registration);

/// Puts one of a registration's rivals in its place; the former place becomes a rival. Forces and further
/// looks are dropped: at the new place they are not known. The doubt rival_chosen tells the probability that
/// the rival had, in percent. The new place is not examined: a refusal stays. Expected errors stay, too: a
/// person's choice exchanges the odds of the two places, so the new one is as sure as the former was.
/// @param is_one_of_looks the cloud is one of several that were registered together: of the share that they
/// see nothing new is known.
/// @param which of registration.rivals. @throws InputError there is none of this number.
Registration choose_rival(const Registration& registration, std::size_t which, const PatientModel& model,
                          const LabelledCloud& cloud, bool is_one_of_looks = false);

}  // namespace glisson::registration
