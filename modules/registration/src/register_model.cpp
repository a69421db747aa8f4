// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/register_model.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"

namespace glisson::registration {
namespace {

using Start = RegisterOptions::Start;

Cancellable<RigidStart> start_of(const PatientModel& model, const LabelledCloud& cloud,
                                 const RegisterOptions& options, const RunContext& context) {
  if (options.start == Start::automatic) return align_rigid(model, cloud, options.rigid, context);
  RigidStart start;
  if (options.start == Start::given) start.camera_from_ct = options.given;
  return start;
}

bool needs_operations(const PatientModel& model, const RegisterOptions& options) {
  return options.operations && !options.elastic.prior && options.elastic.fixed_nodes.empty() &&
         can_simulate_operations(model);
}

Cancellable<std::shared_ptr<const OperationPrior>> operations_of(const PatientModel& model,
                                                                 const OperationOptions& options,
                                                                 const KnownOperations& known,
                                                                 const RunContext& context) {
  if (known.prior && known.options == options) return known.prior;
  auto prior = simulate_operations(model, options, context);
  if (!prior) return {};
  return std::make_shared<const OperationPrior>(std::move(*prior));
}

/// How stiff each tetrahedron is, by its label, over the parenchyma.
std::vector<double> stiffness_of(const TetMesh& mesh, const fem::CompositeOptions& materials) {
  std::vector<double> stiffness;
  for (const int label : mesh.labels) {
    const auto found = materials.by_label.find(static_cast<Label>(label));
    stiffness.push_back(found == materials.by_label.end()
                            ? 1.0
                            : found->second.young_modulus / materials.parenchyma.young_modulus);
  }
  return stiffness;
}

std::vector<std::string> doubts_of(const ContactForceFit& fit, double seen) {
  constexpr double kRival = 5.0, kRivalDistance = 5e-3;
  const LawFit& law = fit.laws[static_cast<std::size_t>(fit.chosen)];
  std::vector<std::string> doubts;
  if (seen < kLittleSeen) doubts.emplace_back("little_surface_seen");
  if (fit.outlier_share > 0.2) doubts.emplace_back("many_outliers");
  if (fit.residual > 5e-3) doubts.emplace_back("residual_large");
  if (fit.inverted > 0 && law.material.law != fem::BodyLaw::linear) doubts.emplace_back("inverted_elements");
  if (std::any_of(fit.laws.begin(), fit.laws.end(), [&](const LawFit& rival) {
        return rival.log_evidence > law.log_evidence - kRival && rival.away > kRivalDistance;
      }))
    doubts.emplace_back("law_ambiguous");
  if (fit.termination != Termination::converged) doubts.emplace_back("forces_not_at_rest");
  return doubts;
}

/// @param elastic with the prior and the other starts, where operations are known.
Cancellable<Registration> register_by_forces(const PatientModel& model, const LabelledCloud& cloud,
                                             CameraFromCt start, const ElasticOptions& elastic,
                                             ContactForceOptions forces, bool pose_known,
                                             std::optional<ContactForceFit>& fit, const RunContext& context) {
  forces = forces_with(model, elastic, std::move(forces));
  forces.pose_known = pose_known;
  std::vector<std::string> doubts;
  if (elastic.prior) {
    std::vector<CameraFromCt> starts = elastic.other_starts;
    starts.insert(starts.begin(), start);
    const auto shape = fit_most_probable_shape(model, *elastic.prior, cloud, starts, elastic.shape, doubts,
                                               context.part(0.0, 0.4));
    if (!shape) return {};
    start = shape->camera_from_ct;
    forces.prior = elastic.prior;
    forces.amplitudes = shape->amplitudes;
    // Neighbouring points share the error of the patient's surface and of the modes: they count for less.
    forces.sigmas = {elastic.shape.sigma_surface / std::sqrt(elastic.shape.information)};
  }
  fit = fit_contact_forces(model, cloud, start, forces, context.part(elastic.prior ? 0.4 : 0.0, 1.0));
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
  made.seen_share = seen_share(surface.mesh(), cloud.points);
  made.doubts = doubts_of(*fit, made.seen_share);
  made.doubts.insert(made.doubts.end(), doubts.begin(), doubts.end());
  return made;
}

}  // namespace

bool takes_forces(Method method, const PatientModel& model, const ElasticOptions& elastic) {
  if (method != Method::automatic) return method == Method::forces;
  // Where nothing is known to hold the organ a bend of the whole is no work of few patches: springs are
  // nearer.
  return model.vessels.empty() && model.landmarks.vena_cava.rows() == 0 && !elastic.prior &&
         !elastic.fixed_nodes.empty();
}

ContactForceOptions forces_with(const PatientModel& model, const ElasticOptions& elastic,
                                ContactForceOptions forces) {
  forces.fixed_nodes = elastic.fixed_nodes;
  if (forces.stiffness.empty()) forces.stiffness = stiffness_of(model.mesh, elastic.materials);
  return forces;
}

void RegisterOptions::validate() const {
  if (start == Start::automatic) rigid.validate();
  if (operations) operation.validate();
  elastic.validate();
  forces.validate();
}

Cancellable<Registered> register_model(const PatientModel& model, const LabelledCloud& cloud,
                                       const RegisterOptions& options, const RunContext& context,
                                       const KnownOperations& known) {
  options.validate();
  const bool is_automatic = options.start == Start::automatic;
  Registered result;
  double done = 0.0;  ///< share of the work
  auto start = start_of(model, cloud, options, context.part(0.0, 0.2));
  if (!start) return {};
  if (is_automatic) done = 0.2, result.rigid_residual = start->residual;
  ElasticOptions elastic = options.elastic;
  if (needs_operations(model, options)) {
    auto prior = operations_of(model, options.operation, known, context.part(done, 0.7));
    if (!prior) return {};
    done = 0.7;
    result.operations = elastic.prior = *prior;
    elastic.other_starts = std::move(start->alternatives);
  }
  const RunContext rest = context.part(done, 1.0);
  auto registered = takes_forces(options.method, model, options.elastic)
                        ? register_by_forces(model, cloud, start->camera_from_ct, elastic, options.forces,
                                             options.start == Start::none, result.forces, rest)
                        : register_elastic(model, cloud, start->camera_from_ct, elastic, rest);
  if (!registered) return {};
  registered->doubts.insert(registered->doubts.begin(), start->doubts.begin(), start->doubts.end());
  result.displacement =
      point_errors(registered->nodes_in_camera, registered->camera_from_ct.apply(model.mesh.vertices));
  result.registration = std::move(*registered);
  return result;
}

}  // namespace glisson::registration
