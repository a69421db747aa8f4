// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud_follower.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/patient/sound_cloud.h"
#include "glisson/registration/pairs.h"

namespace glisson::guidance {
namespace {

/// Metres, mean over the nodes, from one cloud to the next. What lies farther away is another organ, another
/// unit or another place of the camera: closest points bring the model there, with a small residual, and
/// cannot tell. So far away a rigid start, too, counts as another place.
constexpr double kElsewhere = 20e-3;

}  // namespace

CloudFollower::CloudFollower(const PatientModel& model, const Registration& start,
                             const TrackerOptions& options)
    : options_(options), from_camera_(!start.camera_from_ct.matrix().isIdentity()) {
  registration::ElasticOptions elastic = options.cloud;
  elastic.fixed_nodes = options.fixed_nodes;
  if (registration::takes_forces(options.cloud_method, model, elastic))
    forces_.emplace(model, start.camera_from_ct, registration::forces_with(model, elastic));
}

Validity CloudFollower::follow(const LabelledCloud& cloud, int steps, FollowedBody& body,
                               OverlayFrame& overlay) {
  LabelledCloud unlabelled = cloud;
  unlabelled.features.clear();
  unlabelled = sound_cloud(unlabelled, from_camera_, faults_);
  overlay.cloud_faults = faults_;
  seen_ = unlabelled.points;
  if (unlabelled.size() < std::max(10, options_.minimum_pairs)) return Validity::too_few_points;
  const Points there = body.positions(), speed = body.velocities();
  const BoundarySprings springs = body.springs();
  Validity brought = bring(unlabelled, steps, body, overlay);
  if ((body.positions() - there).rowwise().norm().mean() >= kElsewhere) brought = Validity::surface_apart;
  // No way is lost: where a cloud is within reach, its own steps bring the organ there.
  if (brought == Validity::valid) return brought;
  body.restore(there, speed, springs);
  if (forces_) forces_->forget_last();
  return brought;
}

Validity CloudFollower::bring(const LabelledCloud& unlabelled, int steps, FollowedBody& body,
                              OverlayFrame& overlay) {
  const int inverted = body.inverted();
  const Validity followed =
      forces_ ? by_forces(unlabelled, body, overlay) : by_springs(unlabelled, steps, body, overlay);
  if (followed != Validity::valid) return followed;
  if (overlay.pairs < options_.minimum_pairs) return Validity::too_few_points;
  if (overlay.residual > options_.maximum_residual) return Validity::residual_too_large;
  // Forces have judged that themselves (is_beyond_tissue()).
  return !forces_ && body.inverted() > inverted ? Validity::mechanics_failed : Validity::valid;
}

Validity CloudFollower::by_forces(const LabelledCloud& cloud, FollowedBody& body, OverlayFrame& overlay) {
  try {
    const auto fit = forces_->follow(cloud, {});
    body.place(fit->nodes_in_camera);
    overlay.pairs = static_cast<int>(std::lround((1.0 - fit->outlier_share) * cloud.size()));
    overlay.residual = fit->residual;
    return Validity::valid;
  } catch (const registration::ForeignCloud&) {
    return Validity::surface_apart;
  } catch (const NumericalError&) {
    return Validity::mechanics_failed;
  } catch (const InputError&) {
    return Validity::too_few_points;  // too few of the cloud's points are usable
  }
}

Validity CloudFollower::by_springs(const LabelledCloud& cloud, int steps, FollowedBody& body,
                                   OverlayFrame& overlay) const {
  const auto prepared = registration::prepare_cloud(cloud, {options_.cloud.reference_density_per_cm2});
  const double k = options_.cloud.k_surface_max * options_.cloud.final_stiffening *
                   options_.materials.parenchyma.young_modulus;
  std::vector<registration::Pair> pairs;
  for (int i = 0; i < steps; ++i) {
    pairs = registration::find_pairs(prepared, body.surface(), {});
    const auto pull = [&](std::vector<fem::AttachedLoad>& loads) {
      for (const registration::Pair& pair : pairs)
        if (pair.kept)
          loads.push_back(registration::pair_load(pair, body.surface(), options_.cloud.form, options_.cloud.s,
                                                  k * prepared.weight[static_cast<std::size_t>(pair.point)],
                                                  options_.cloud.tangential));
    };
    if (!body.step(pull)) return Validity::mechanics_failed;
  }
  pairs = registration::find_pairs(prepared, body.surface(), {});
  overlay.pairs =
      static_cast<int>(std::count_if(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.kept; }));
  overlay.residual = registration::mean_distance(pairs);
  return Validity::valid;
}

}  // namespace glisson::guidance
