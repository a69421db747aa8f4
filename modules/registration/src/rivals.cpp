// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/rivals.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/rigid.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"

namespace glisson::registration {
namespace {

constexpr std::size_t kMostRivals = 3;

double apart(const Points& a, const Points& b) { return (a - b).rowwise().norm().mean(); }

}  // namespace

std::vector<RegistrationRival> plausible_rivals(const PointsIn<CameraFrame>& chosen,
                                                std::vector<RegistrationRival> candidates) {
  static const double kLeast = std::exp(-10.0);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  std::vector<RegistrationRival> kept;
  for (RegistrationRival& one : candidates) {
    if (kept.size() == kMostRivals || one.probability < kLeast) break;
    const auto is_near = [&](const Points& other) { return apart(one.nodes_in_camera, other) < kRivalAway; };
    if (is_near(chosen) || std::any_of(kept.begin(), kept.end(), [&](const RegistrationRival& other) {
          return is_near(other.nodes_in_camera);
        }))
      continue;
    kept.push_back(std::move(one));
  }
  return kept;
}

double distance_of(const RegistrationRival& rival, const Registration& registration) {
  return apart(rival.nodes_in_camera, registration.nodes_in_camera);
}

Registration choose_rival(const Registration& registration, std::size_t which, const PatientModel& model,
                          const LabelledCloud& cloud) {
  if (which >= registration.rivals.size())
    throw InputError("registration", "rival",
                     "there are " + std::to_string(registration.rivals.size()) + " other places, not " +
                         std::to_string(which + 1),
                     "Choose one of those that it tells");
  Registration chosen = registration;
  chosen.looks.clear();  // of the former place
  double own = 1.0;
  for (const RegistrationRival& rival : registration.rivals) own -= rival.probability;
  RegistrationRival& place = chosen.rivals[which];
  std::swap(chosen.nodes_in_camera, place.nodes_in_camera);
  const double probability = std::exchange(place.probability, std::max(0.0, own));
  std::stable_sort(chosen.rivals.begin(), chosen.rivals.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  chosen.camera_from_ct = fit_rigid<CameraFrame, CtFrame>(model.mesh.vertices, chosen.nodes_in_camera);
  chosen.forces.clear();
  MovingSurface surface(model, SurfaceDetail::fine);
  surface.move(chosen.nodes_in_camera);
  chosen.seen_share = seen_share(surface.mesh(), cloud.points);
  chosen.residual = summarise(distances_to_surface(cloud.points, surface.mesh())).mean;
  std::erase_if(chosen.doubts, [](const std::string& doubt) { return doubt.starts_with("rival_chosen"); });
  chosen.doubts.push_back("rival_chosen " + std::to_string(std::lround(100.0 * probability)));
  return chosen;
}

}  // namespace glisson::registration
