// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/register_model.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "glisson/registration/examine.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"
#include "glisson/registration/refusal.h"
#include "verdict.h"

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

/// Tools act on what is seen and next to it; what they press and pull is no smaller than they are, and a
/// patient's mesh is coarse.
constexpr double kToolReach = 40e-3, kToolSpacing = 20e-3, kToolRadius = 30e-3;  // m
constexpr int kPatientStages = 3;

/// @param shapes where operations are known: their modes and the forces of tools are found together, from the
/// most probable shape and, without any, from the rigid starts.
Cancellable<Registration> register_by_forces(const PatientModel& model, const LabelledCloud& cloud,
                                             CameraFromCt start, const ElasticOptions& elastic,
                                             const std::optional<ShapeFits>& shapes,
                                             ContactForceOptions forces, bool pose_known,
                                             std::optional<ContactForceFit>& fit, const RunContext& context) {
  forces = forces_with(model, elastic, std::move(forces));
  forces.pose_known = pose_known;
  if (shapes) {
    forces.other_starts = elastic.other_starts;
    forces.other_starts.insert(forces.other_starts.begin(), start);
    start = shapes->best().camera_from_ct;
    forces.prior = elastic.prior;
    forces.patch_reach = kToolReach;
    forces.patch_spacing = kToolSpacing;
    forces.patch_radius = kToolRadius;
    forces.amplitudes = shapes->best().amplitudes;
    // Neighbouring points share the error of the patient's surface and of the modes: they count for less.
    forces.sigmas.assign(kPatientStages, elastic.shape.sigma_surface / std::sqrt(elastic.shape.information));
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
  made.seen_share = seen_share(surface.mesh(), cloud.points);
  made.doubts = doubts_of(*fit, made.seen_share);
  if (shapes) made.doubts.insert(made.doubts.end(), shapes->doubts.begin(), shapes->doubts.end());
  return made;
}

Cancellable<ShapeFits> shapes_from(const PatientModel& model, const LabelledCloud& cloud,
                                   const CameraFromCt& start, const ElasticOptions& elastic,
                                   const RunContext& context) {
  std::vector<CameraFromCt> starts = elastic.other_starts;
  starts.insert(starts.begin(), start);
  return fit_shapes(model, *elastic.prior, cloud, starts, elastic.shape, context);
}

/// Each of the other shapes is as probable as the cloud makes it.
void add_rivals(const ShapeFits& shapes, ErrorModel& error) {
  std::vector<double> odds;
  double sum = 0.0;
  for (const ShapeFit& fit : shapes.fits) {
    odds.push_back(std::exp(-0.5 * (fit.cost - shapes.best().cost)));
    sum += odds.back();
  }
  for (std::size_t k = 1; k < odds.size(); ++k)
    if (odds[k] > 1e-4 * sum) error.add_rival(shapes.fits[k].nodes_in_camera, odds[k] / sum);
}

/// Motion of the nodes by the forces alone, rms, m.
double moved_by_forces(const PatientModel& model, const ContactForceFit& fit, const OperationPrior& prior) {
  const Points without = fit.camera_from_ct.apply(prior.shape(model.mesh.vertices, fit.amplitudes));
  return std::sqrt((fit.nodes_in_camera - without).rowwise().squaredNorm().mean());
}

ErrorModel error_of(const PatientModel& model, const LabelledCloud& cloud, const ElasticOptions& elastic,
                    const std::optional<ShapeFits>& shapes, const Registered& made,
                    const Registration& registration) {
  const PreparedCloud prepared = prepare_cloud(cloud, {3.9, 600, 30});
  const ShapeFit* shape = shapes && !made.forces ? &shapes->best() : nullptr;
  ErrorModelOptions known;
  known.fixed_nodes = elastic.fixed_nodes;
  known.pose_known = !elastic.fixed_nodes.empty();
  const bool together = made.forces && elastic.prior;
  // Where tools are at work there may be more of them.
  if (together)
    known.unknown_forces =
        std::max(known.unknown_forces, moved_by_forces(model, *made.forces, *elastic.prior));
  ErrorModel error(model, elastic.prior.get(),
                   shape      ? shape->amplitudes
                   : together ? made.forces->amplitudes
                              : Eigen::VectorXd(),
                   shape ? shape->camera_from_ct : registration.camera_from_ct,
                   shape ? shape->nodes_in_camera : registration.nodes_in_camera, prepared,
                   roughness_of(prepared), known);
  if (made.forces)
    for (const RivalFit& rival : made.forces->rivals)
      error.add_rival(rival.nodes_in_camera, rival.probability);
  else if (shapes)
    add_rivals(*shapes, error);
  return error;
}

std::vector<LesionError> lesions_of(const PatientModel& model, const ErrorModel& error,
                                    const Registration& registration) {
  const auto centres = lesion_centres(model);
  Points points(static_cast<Eigen::Index>(centres.size()), 3);
  for (std::size_t i = 0; i < centres.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = centres[i].second.transpose();
  const Binding binding = bind_points(model.mesh, points);
  const Points found = binding.apply(model.mesh, registration.nodes_in_camera);
  const std::vector<Eigen::Matrix3d> covariances = error.covariances(model.mesh, binding);
  std::vector<LesionError> lesions;
  for (std::size_t i = 0; i < centres.size(); ++i)
    lesions.push_back({centres[i].first, found.row(static_cast<Eigen::Index>(i)).transpose(), covariances[i],
                       mean_error(covariances[i])});
  return lesions;
}

/// Each doubt once: the rigid start and the elastic stages may share one.
void tell_once(std::vector<std::string>& doubts) {
  std::vector<std::string> told;
  for (std::string& doubt : doubts)
    if (std::find(told.begin(), told.end(), doubt) == told.end()) told.push_back(std::move(doubt));
  doubts = std::move(told);
}

/// Logarithm of the odds of a shape of this cost against the best of the cloud's mirror image.
Cancellable<double> mirror_odds(const PatientModel& model, const LabelledCloud& cloud,
                                const RegisterOptions& options, const ElasticOptions& elastic, double cost,
                                const RunContext& context) {
  constexpr std::size_t kOthers = 1;
  constexpr int kIterations = 40;
  const LabelledCloud image = mirrored(cloud);
  auto start = align_rigid(model, image, options.rigid, context.part(0.0, 0.6));
  if (!start) return {};
  ElasticOptions control = elastic;
  control.other_starts = std::move(start->alternatives);
  control.other_starts.resize(std::min(control.other_starts.size(), kOthers));
  control.shape.max_iterations = std::min(control.shape.max_iterations, kIterations);
  const auto shapes = shapes_from(model, image, start->camera_from_ct, control, context.part(0.6, 1.0));
  if (!shapes) return {};
  return 0.5 * (shapes->best().cost - cost);
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

Cancellable<ExaminedRegistration> register_and_examine(const PatientModel& model, const LabelledCloud& cloud,
                                                       const RegisterOptions& options,
                                                       const RunContext& context,
                                                       const KnownOperations& known) {
  options.validate();
  const bool is_automatic = options.start == Start::automatic;
  ExaminedRegistration examined;
  Registered& result = examined.registered;
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
  std::optional<ShapeFits> shapes;
  const double judged = done + 0.7 * (1.0 - done);  // the control takes about as long as the start
  if (elastic.prior) {
    const double fitted = done + 0.4 * (judged - done);
    shapes = shapes_from(model, cloud, start->camera_from_ct, elastic, context.part(done, fitted));
    if (!shapes) return {};
    done = fitted;
  }
  const RunContext rest = context.part(done, judged);
  const bool by_forces = takes_forces(options.method, model, options.elastic) ||
                         (options.method == Method::automatic && shapes.has_value());
  auto registered =
      by_forces ? register_by_forces(model, cloud, start->camera_from_ct, elastic, shapes, options.forces,
                                     options.start == Start::none, result.forces, rest)
      : shapes  ? register_elastic(model, cloud, *shapes, elastic, rest)
                : register_elastic(model, cloud, start->camera_from_ct, elastic, rest);
  if (!registered) return {};
  examined.error =
      std::make_shared<const ErrorModel>(error_of(model, cloud, elastic, shapes, result, *registered));
  examined.lesions = lesions_of(model, *examined.error, *registered);
  examined.findings = examine({model, cloud, *registered, shapes ? &*shapes : nullptr, *examined.error});
  if (is_automatic && shapes) {
    const auto odds =
        mirror_odds(model, cloud, options, elastic, shapes->best().cost, context.part(judged, 1.0));
    if (!odds) return {};
    examined.findings.mirror_odds = *odds;
  }
  registered->doubts.insert(registered->doubts.begin(), start->doubts.begin(), start->doubts.end());
  const Verdict verdict = judge(examined.findings);
  registered->doubts.insert(registered->doubts.end(), verdict.doubts.begin(), verdict.doubts.end());
  if (verdict.refused) registered->doubts.insert(registered->doubts.begin(), kRefused);
  tell_once(registered->doubts);
  result.displacement =
      point_errors(registered->nodes_in_camera, registered->camera_from_ct.apply(model.mesh.vertices));
  result.registration = std::move(*registered);
  return examined;
}

Cancellable<Registered> register_model(const PatientModel& model, const LabelledCloud& cloud,
                                       const RegisterOptions& options, const RunContext& context,
                                       const KnownOperations& known) {
  auto examined = register_and_examine(model, cloud, options, context, known);
  if (!examined) return {};
  return std::move(examined->registered);
}

}  // namespace glisson::registration
