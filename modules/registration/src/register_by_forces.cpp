// SPDX-License-Identifier: GPL-3.0-or-later
#include "register_by_forces.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "fit_contact_forces.h"
#include "glisson/geometry/mesh.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"
#include "glisson/registration/register_model.h"
#include "looks.h"

namespace glisson::registration {
namespace {

std::vector<std::string> doubts_of(const ContactForceFit& fit, int elements, double seen) {
  const LawFit& law = fit.laws[static_cast<std::size_t>(fit.chosen)];
  std::vector<std::string> doubts;
  if (seen < kLittleSeen) doubts.emplace_back("little_surface_seen");
  if (fit.outlier_share > 0.2) doubts.emplace_back("many_outliers");
  if (fit.residual > kLargeResidual) doubts.emplace_back("residual_large");
  // The linear law itself turns single elements inside out.
  if (fit.inverted > 0 && (law.material.law != fem::BodyLaw::linear || is_beyond_tissue(fit, elements)))
    doubts.emplace_back("inverted_elements");
  if (is_law_ambiguous(fit)) doubts.emplace_back("law_ambiguous");
  if (fit.termination != Termination::converged) doubts.emplace_back("forces_not_at_rest");
  return doubts;
}

/// Of the patches on which tools may act: how far from what is seen, how far apart, how wide. Not finer:
/// tools are not smaller, and a patient's mesh is coarse.
constexpr double kToolReach = 40e-3, kToolSpacing = 20e-3, kToolRadius = 30e-3;  // m
constexpr int kPatientStages = 3;
constexpr double kToolPrice = 1.0;  ///< as if one of all patches were expected to act
/// More forces than this are a doubt: where one is expected, five or more come in 4 of 1,000 operations
/// (Poisson), so they rather explain something else.
constexpr std::size_t kMostTools = 4;

}  // namespace

LabelledCloud as_looked(const LabelledCloud& cloud, const LookMotions& looks) {
  LabelledCloud moved = cloud;
  if (!looks.empty()) move_looks(cloud, looks, moved);
  return moved;
}

Cancellable<Registration> register_by_forces(const PatientModel& model, const LabelledCloud& cloud,
                                             CameraFromCt start, const ElasticOptions& elastic,
                                             const std::optional<ShapeFits>& shapes,
                                             ContactForceOptions forces, bool pose_known,
                                             std::optional<ContactForceFit>& fit, const RunContext& context) {
  forces = forces_with(model, elastic, std::move(forces));
  forces.pose_known = pose_known;
  if (shapes) {
    // A probable shape may have bent the wrong way under a tool, so each place is also begun at rest.
    for (const ShapeFit* place : shapes->places()) {
      forces.other_places.push_back({place->start.camera_from_ct, {}, place->start.looks});
      if (place != &shapes->best())
        forces.other_places.push_back({place->camera_from_ct, place->amplitudes, place->looks});
    }
    forces.looks = shapes->best().looks;
    start = shapes->best().camera_from_ct;
    forces.prior = elastic.prior;
    forces.patch_reach = kToolReach;
    forces.patch_spacing = kToolSpacing;
    forces.patch_radius = kToolRadius;
    forces.amplitudes = shapes->best().amplitudes;
    forces.patch_price = kToolPrice;
    // Neighbouring points share the error of the patient's surface and of the modes.
    forces.information = elastic.shape.information;
    forces.sigmas.assign(kPatientStages, elastic.shape.sigma_surface);
  }
  fit = fit_contact_forces(model, cloud, start, forces, context);
  if (!fit) return {};
  Registration made;
  made.camera_from_ct = fit->camera_from_ct;
  made.nodes_in_camera = fit->nodes_in_camera;
  made.termination = fit->termination;
  made.steps = fit->iterations;
  made.plateaus = static_cast<int>(forces.sigmas.size());
  made.residual = fit->residual;
  MovingSurface surface(model, SurfaceDetail::fine);
  surface.move(fit->nodes_in_camera);
  made.seen_share = seen_share(surface.mesh(), as_looked(cloud, fit->looks).points);
  made.doubts = doubts_of(*fit, model.mesh.tetrahedron_count(), made.seen_share);
  if (!shapes) return made;
  // The forces' law counts against the shape that the modes make, which may itself be folded.
  TetMesh bent = model.mesh;
  bent.vertices = fit->nodes_in_camera;
  if ((tetrahedron_volumes(bent).array() <= 0.0).any()) made.doubts.emplace_back("inverted_elements");
  if (fit->forces.size() > kMostTools)
    made.doubts.push_back("forces_many " + std::to_string(fit->forces.size()) + " " +
                          std::to_string(kMostTools));
  made.doubts.insert(made.doubts.end(), shapes->doubts.begin(), shapes->doubts.end());
  return made;
}

}  // namespace glisson::registration
