// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/rivals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/sound_cloud.h"
#include "glisson/registration/forks.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"

namespace glisson::registration {
namespace {

constexpr std::size_t kMostRivals = 3;
constexpr double kPlausible = 0.01;
constexpr double kElsewhere = 20e-3, kPlace = 25e-3;  // m
constexpr double kSameFit = 0.5e-3;                   ///< m: of two that have come to the same end

double apart(const Points& a, const Points& b) { return (a - b).rowwise().norm().mean(); }

/// @param least mean distance from which on two fits are two. @param most from the chosen one.
std::vector<RegistrationRival> weighed(const Points& chosen, std::vector<OtherFit> fits, double votes,
                                       double least, double most) {
  std::stable_sort(fits.begin(), fits.end(),
                   [](const OtherFit& a, const OtherFit& b) { return a.log_odds > b.log_odds; });
  std::vector<RegistrationRival> places;
  double total = 1.0;
  for (OtherFit& fit : fits) {
    const double away = apart(fit.nodes_in_camera, chosen);
    if (!(away > least) || away > most ||
        std::any_of(places.begin(), places.end(), [&](const RegistrationRival& better) {
          return !(apart(fit.nodes_in_camera, better.nodes_in_camera) > least);
        }))
      continue;
    places.push_back({std::move(fit.nodes_in_camera), std::exp(fit.log_odds / votes)});
    total += places.back().probability;
  }
  for (RegistrationRival& place : places) place.probability /= total;
  return places;
}

}  // namespace

bool are_rivals(const Points& a, const Points& b) { return apart(a, b) > kRivalAway; }

double votes_of_a_place(double information) {
  const double points_per_m2 = 1e4 * CloudOptions().reference_density_per_cm2;
  return std::max(1.0, information * points_per_m2 * kPlace * kPlace);
}

std::vector<RegistrationRival> weigh_places(const Points& chosen, std::vector<OtherFit> fits, double votes) {
  return weighed(chosen, std::move(fits), votes, kRivalAway, std::numeric_limits<double>::infinity());
}

std::vector<RegistrationRival> weigh_near(const Points& chosen, std::vector<OtherFit> fits, double votes) {
  return weighed(chosen, std::move(fits), votes, kSameFit, kRivalAway);
}

double elsewhere(const Points& chosen, const std::vector<RegistrationRival>& places) {
  double sum = 0.0;
  for (const RegistrationRival& place : places)
    if (apart(place.nodes_in_camera, chosen) > kElsewhere) sum += place.probability;
  return sum;
}

std::vector<RegistrationRival> plausible_rivals(std::vector<RegistrationRival> places) {
  std::erase_if(places, [](const RegistrationRival& place) { return place.probability < kPlausible; });
  if (places.size() > kMostRivals) places.resize(kMostRivals);
  return places;
}

double distance_of(const RegistrationRival& rival, const Registration& registration) {
  return apart(rival.nodes_in_camera, registration.nodes_in_camera);
}

Registration choose_rival(const Registration& registration, std::size_t which, const PatientModel& model,
                          const LabelledCloud& cloud, bool is_one_of_looks) {
  if (which >= registration.rivals.size())
    throw InputError("registration", "rival",
                     "there are " + std::to_string(registration.rivals.size()) + " other places, not " +
                         std::to_string(which + 1),
                     "Choose one of those that it tells");
  Registration chosen = registration;
  chosen.looks.clear();  // of the former place, as what is noted of them
  std::erase_if(chosen.notes, [](const std::string& note) { return note.starts_with("look."); });
  double own = 1.0;
  for (const RegistrationRival& rival : registration.rivals) own -= rival.probability;
  RegistrationRival& place = chosen.rivals[which];
  std::swap(chosen.nodes_in_camera, place.nodes_in_camera);
  turn_errors(chosen, registration.nodes_in_camera, chosen.nodes_in_camera);
  const double probability = std::exchange(place.probability, std::max(0.0, own));
  std::stable_sort(chosen.rivals.begin(), chosen.rivals.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  chosen.camera_from_ct = fit_rigid<CameraFrame, CtFrame>(model.mesh.vertices, chosen.nodes_in_camera);
  chosen.forces.clear();
  place_forks(model, chosen);
  MovingSurface surface(model, SurfaceDetail::fine);
  surface.move(chosen.nodes_in_camera);
  CloudFaults known;  // told when it was registered
  const PointsIn<CameraFrame> points = sound_cloud(cloud, true, known).points;
  if (!is_one_of_looks) chosen.seen_share = seen_share(surface.mesh(), points);
  chosen.residual = summarise(distances_to_surface(points, surface.mesh())).mean;
  std::erase_if(chosen.doubts, [](const std::string& doubt) {
    return doubt.starts_with("rival_chosen") || doubt == "residual_large" || doubt == "little_surface_seen";
  });
  if (chosen.residual > kLargeResidual) chosen.doubts.emplace_back("residual_large");
  if (chosen.seen_share < kLittleSeen) chosen.doubts.emplace_back("little_surface_seen");
  chosen.doubts.push_back("rival_chosen " + std::to_string(std::lround(100.0 * probability)));
  return chosen;
}

}  // namespace glisson::registration
