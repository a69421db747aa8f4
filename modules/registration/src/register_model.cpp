// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/register_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "elastic.h"
#include "examine.h"
#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/forks.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/next_look.h"
#include "glisson/registration/pairs.h"
#include "glisson/registration/refusal.h"
#include "glisson/registration/rivals.h"
#include "lesion_errors.h"
#include "looks.h"
#include "mirror_control.h"
#include "register_by_forces.h"
#include "rigid.h"
#include "verdict.h"

namespace glisson::registration {
namespace {

using Start = RegisterOptions::Start;

Cancellable<RigidStart> start_of(const PatientModel& model, const LabelledCloud& cloud,
                                 const RegisterOptions& options, const RunContext& context) {
  if (options.start == Start::automatic) return align_rigid(model, cloud, options.rigid, context);
  if (options.start == Start::near)
    return align_rigid_near(model, cloud, options.given, options.rigid, context);
  RigidStart start;
  if (options.start == Start::given) start.camera_from_ct = options.given;
  return start;
}

/// Whether shapes are to be told apart by how probable they are. Without a vena cava only where the pose is
/// found with them.
bool needs_prior(const PatientModel& model, const RegisterOptions& options, const ElasticOptions& elastic) {
  return options.operations && options.method != Method::paper && !elastic.prior &&
         elastic.fixed_nodes.empty() && (can_simulate_operations(model) || options.start != Start::none);
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

/// Where else fits have ended.
struct OtherFits {
  Points here;  ///< where the chosen one has
  std::vector<OtherFit> fits;
  double votes = 1.0;
};
OtherFits other_fits(const std::optional<ShapeFits>& shapes, const Registered& made,
                     const Registration& registration, const ElasticOptions& elastic) {
  OtherFits others{registration.nodes_in_camera, {}, votes_of_a_place(elastic.shape.information)};
  if (made.forces) {
    others.fits = made.forces->others;
    if (!shapes) others.votes = 1.0;
  } else if (shapes) {
    others.here = shapes->best().nodes_in_camera;
    for (const ShapeFit& fit : shapes->fits)
      others.fits.push_back({fit.nodes_in_camera, -0.5 * (fit.cost - shapes->best().cost)});
  }
  return others;
}

/// N for a Young's modulus of 1 kPa, before the camera.
std::vector<FoundForce> found_forces(const ContactForceFit& fit) {
  std::vector<FoundForce> found;
  for (const ContactForce& one : fit.forces)
    found.push_back({one.node, 1e3 * (fit.camera_from_ct.rotation * one.force)});
  return found;
}

ErrorModel error_of(const PatientModel& model, const LabelledCloud& cloud, const ElasticOptions& elastic,
                    const std::optional<ShapeFits>& shapes, const Registered& made,
                    const Registration& registration, const OtherFits& others,
                    const std::vector<RegistrationRival>& rivals, bool pose_known,
                    const RunContext& context) {
  const PreparedCloud prepared = prepare_cloud(cloud, {3.9, 600, 30});
  const ShapeFit* shape = shapes && !made.forces ? &shapes->best() : nullptr;
  ErrorModelOptions known;
  known.sigma = elastic.shape.sigma_surface;
  known.fixed_nodes = elastic.fixed_nodes;
  known.pose_known = pose_known;
  if (!elastic.materials.by_label.empty())
    known.stiffness = fem::stiffness_over_parenchyma(model.mesh, elastic.materials);
  const bool together = made.forces && elastic.prior;
  if (elastic.prior) known.unforeseen = 0.0;  // the prior knows of them
  ErrorModel error(model, elastic.prior.get(),
                   shape      ? shape->amplitudes
                   : together ? made.forces->amplitudes
                              : Eigen::VectorXd(),
                   shape ? shape->camera_from_ct : registration.camera_from_ct,
                   shape ? shape->nodes_in_camera : registration.nodes_in_camera, prepared,
                   roughness_of(prepared, context), known, context);
  if (context.cancelled()) return error;
  double here = 1.0;
  for (const RegistrationRival& rival : rivals) {
    error.add_rival(rival.nodes_in_camera, rival.probability);
    here -= rival.probability;
  }
  for (const RegistrationRival& near : weigh_near(others.here, others.fits, others.votes))
    if (const double p = here * near.probability; p > 1e-4) error.add_rival(near.nodes_in_camera, p);
  return error;
}

/// Each doubt once: the rigid start and the elastic stages may share one.
void tell_once(std::vector<std::string>& doubts) {
  std::vector<std::string> told;
  for (std::string& doubt : doubts)
    if (std::find(told.begin(), told.end(), doubt) == told.end()) told.push_back(std::move(doubt));
  doubts = std::move(told);
}

}  // namespace

bool takes_forces(Method method, const PatientModel& model, const ElasticOptions& elastic) {
  if (method != Method::automatic) return method == Method::forces;
  // Forces only for a bare body that fixed nodes hold. Where nothing is known to hold the organ it bends as a
  // whole, which few patches do not explain; springs come closer.
  return model.vessels.empty() && model.landmarks.vena_cava.rows() == 0 && !elastic.prior &&
         !elastic.fixed_nodes.empty();
}

ContactForceOptions forces_with(const PatientModel& model, const ElasticOptions& elastic,
                                ContactForceOptions forces) {
  forces.fixed_nodes = elastic.fixed_nodes;
  if (forces.stiffness.empty())
    forces.stiffness = fem::stiffness_over_parenchyma(model.mesh, elastic.materials);
  // A ratio that somebody gives is not for the evidence to choose.
  const double ratio = elastic.materials.parenchyma.poisson_ratio;
  if (!elastic.materials.ratio_is_given && ratio == fem::Material().poisson_ratio) return forces;
  for (fem::BodyMaterial& material : forces.materials) material.poisson_ratio = ratio;
  forces.poisson_ratios.clear();
  return forces;
}

ElasticOptions elastic_of(const RegisterOptions& options, const PatientModel& model) {
  ElasticOptions elastic =
      options.elastic ? *options.elastic : options_for(model, options.landmarks_are_placed);
  if (options.materials) elastic.materials = *options.materials;
  elastic.materials = fem::with_tissue(std::move(elastic.materials), options.tissue, model.mesh);
  if (!options.fixed_nodes.empty()) elastic.fixed_nodes = options.fixed_nodes;
  return elastic;
}

OperationOptions operation_of(const RegisterOptions& options, const PatientModel& model) {
  OperationOptions operation = options.operation;
  if (!options.materials && options.tissue.empty()) return operation;
  const fem::CompositeOptions materials = elastic_of(options, model).materials;
  operation.young_modulus = materials.parenchyma.young_modulus;
  operation.poisson_ratio = materials.parenchyma.poisson_ratio;
  for (const auto& [label, material] : materials.by_label) operation.lesions[label] = material.young_modulus;
  return operation;
}

namespace {

/// @throws InputError landmarks alone are labelled: they say where the organ is, not how it is bent.
void require_surface(const LabelledCloud& cloud) {
  int seen = 0;
  for (int i = 0; i < cloud.size(); ++i) seen += cloud.feature(i) == Feature::surface;
  if (cloud.size() >= kMinimumPoints && seen < kMinimumPoints)
    throw InputError("cloud", "labels",
                     "show " + std::to_string(seen) + " points of the liver's surface, at least " +
                         std::to_string(kMinimumPoints) + " are needed",
                     "Draw a region on its surface, too");
}

/// A landmark that the model lacks is a part of the surface like any other: its mark would draw whatever
/// surface is nearest.
void without_unknown_landmarks(const PatientModel& model, LabelledCloud& cloud) {
  const bool no_margin = model.landmarks.anterior_margin.rows() == 0;
  const bool no_notch = model.landmarks.umbilical_notch.rows() == 0;
  for (Feature& feature : cloud.features)
    if ((no_margin && feature == Feature::anterior_margin) ||
        (no_notch && feature == Feature::umbilical_notch))
      feature = Feature::surface;
}

/// Every step's own options with the threads of all.
RegisterOptions shared_out(RegisterOptions options) {
  options.rigid.threads = options.operation.threads = options.forces.threads = options.threads;
  return options;
}

}  // namespace

void RegisterOptions::validate() const {
  OptionCheck("register options")(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
  if (start == Start::automatic || start == Start::near) rigid.validate();
  if (operations) operation.validate();
  if (elastic) elastic->validate();
  if (materials) materials->validate();
  tissue.validate();
  forces.validate();
}

namespace {

/// One registration, stage by stage. Each stage returns false when it was cancelled.
class Run {
 public:
  Run(const PatientModel& model, const LabelledCloud& cloud, const RegisterOptions& options,
      const KnownOperations& known, const RunContext& context)
      : model_(model),
        options_(shared_out(options)),
        known_(known),
        context_(context),
        elastic_(elastic_of(options, model)) {
    elastic_.shape.threads = options_.threads;
    // As the simulated operations, that the camera is a laparoscope needs a liver that lies in its CT. A hand
    // may put the camera anywhere.
    options_.rigid.from_cavity = elastic_.shape.from_cavity =
        options_.rigid.from_cavity ||
        (options_.start == RegisterOptions::Start::automatic && needs_prior(model_, options_, elastic_) &&
         can_simulate_operations(model_));
    const bool from_camera = options_.start != RegisterOptions::Start::none;
    cloud_ = sound_cloud(cloud, from_camera, examined_.cloud_faults);
    for (LabelledCloud& look : options_.looks) look = sound_cloud(look, from_camera, examined_.cloud_faults);
    require_surface(cloud_);
    without_unknown_landmarks(model_, cloud_);
    for (LabelledCloud& look : options_.looks) without_unknown_landmarks(model_, look);
  }

  Cancellable<ExaminedRegistration> run() {
    if (!find_start() || !join() || !know_shapes() || !fit_the_shapes() || !deform() || !examine_it())
      return {};
    return std::move(examined_);
  }

 private:
  /// The next stage's part of the work, up to this share of all.
  RunContext up_to(double share) { return context_.part(std::exchange(done_, share), share); }
  /// Whether the pose is to be found: who gives it exactly vouches for it.
  bool is_sought() const { return options_.start == Start::automatic || options_.start == Start::near; }
  /// Fixed nodes stand where the start puts them: only one that is given is no guess.
  bool knows_pose() const { return !elastic_.fixed_nodes.empty() && !is_sought(); }
  Registered& result() { return examined_.registered; }

  bool find_start() {
    auto start = start_of(model_, cloud_, options_, up_to(is_sought() ? 0.2 : 0.0));
    if (!start) return false;
    start_ = std::move(*start);
    if (is_sought()) result().rigid_residual = start_.residual;
    return true;
  }

  /// Where no start is sought the looks are in the cloud's frame, too, as far as anybody knows.
  bool join() {
    starts_ = starts_of(start_.camera_from_ct, start_.alternatives);
    if (options_.looks.empty()) return true;
    looks_ = options_.looks;
    looks_.insert(looks_.begin(), cloud_);
    into_first_.resize(looks_.size());
    if (options_.start == Start::none) {
      cloud_ = joined(looks_, into_first_);
      return true;
    }
    auto found = join_looks(model_, cloud_, options_.looks, start_, options_.rigid, up_to(0.3));
    if (!found) return false;
    cloud_ = std::move(found->cloud);
    starts_ = std::move(found->starts);
    into_first_ = std::move(found->into_first);
    return true;
  }

  bool know_shapes() {
    if (!needs_prior(model_, options_, elastic_)) return true;
    const OperationOptions operation = operation_of(options_, model_);
    if (can_simulate_operations(model_)) {
      auto prior = operations_of(model_, operation, known_, up_to(0.7));
      if (!prior) return false;
      result().operations = elastic_.prior = *prior;
    } else {
      elastic_.prior =
          std::make_shared<const OperationPrior>(unknown_operations(model_, operation, context_.quiet()));
      if (context_.cancelled()) return false;
    }
    return true;
  }

  bool fit_the_shapes() {
    if (!elastic_.prior) return true;
    auto shapes = fit_shapes(model_, *elastic_.prior, cloud_, starts_, elastic_.shape,
                             up_to(done_ + 0.3 * (1.0 - done_)));
    if (!shapes) return false;
    shapes_ = std::move(*shapes);
    begin_control();
    return looks_.empty() || compare_looks();
  }

  /// Begins the mirror's control on the second thread, if there is one: it needs nothing but the prior, and
  /// the steps that follow take one thread. Not with several looks, which the control first has to join as
  /// the shape has found them.
  void begin_control() {
    if (!is_sought() || options_.threads < 2 || !looks_.empty()) return;
    control_.begin_beside(model_, cloud_, options_, elastic_, context_);
  }

  /// Neighbouring points share errors: votes are counted as for other places.
  bool compare_looks() {
    const auto odds = one_shape_odds(model_, *elastic_.prior, looks_, into_first_, shapes_->best(),
                                     elastic_.shape, context_.quiet());
    if (!odds) return false;
    looks_differ_ = 1.0 / (1.0 + std::exp(*odds / votes_of_a_place(elastic_.shape.information)));
    return true;
  }

  bool deform() {
    // Where the control comes after it, it takes about as long as the start.
    const double judged = done_ + (control_.has_begun() ? 0.9 : 0.7) * (1.0 - done_);
    const bool either = options_.method == Method::automatic && shapes_.has_value();
    Cancellable<Registration> made;
    if (either || takes_forces(options_.method, model_, elastic_))
      made = by_forces(either, up_to(either ? 0.5 * (done_ + judged) : judged));
    // If no force was worth its price, the shape alone explains what is seen.
    if (either && made && result().forces->forces.empty()) result().forces.reset();
    if (context_.cancelled()) return false;
    if (result().forces)
      cloud_ = as_looked(cloud_, result().forces->looks);
    else if (shapes_)
      cloud_ = as_looked(cloud_, shapes_->best().looks);
    if (!result().forces) {
      const RunContext rest = up_to(judged);
      made = shapes_ ? register_elastic(model_, cloud_, *shapes_, elastic_, rest)
                     : register_elastic(model_, cloud_, start_.camera_from_ct, elastic_, rest);
    }
    if (!made) return false;
    registration_ = std::move(*made);
    return true;
  }

  /// @param is_choice whether there is another way: then forces without an equilibrium are none.
  Cancellable<Registration> by_forces(bool is_choice, const RunContext& context) {
    try {
      return register_by_forces(model_, cloud_, start_.camera_from_ct, elastic_, shapes_, options_.forces,
                                options_.start == Start::none, result().forces, context);
    } catch (const NumericalError&) {
      if (!is_choice) throw;
      result().forces.reset();
      return {};
    }
  }

  bool examine_it() {
    const OtherFits others = other_fits(shapes_, result(), registration_, elastic_);
    std::vector<RegistrationRival> rivals = weigh_places(others.here, others.fits, others.votes);
    examined_.error = std::make_shared<const ErrorModel>(error_of(
        model_, cloud_, elastic_, shapes_, result(), registration_, others, rivals, knows_pose(), context_));
    if (context_.cancelled()) return false;
    bound_lesions_ = bound_lesions(model_);
    examined_.lesions = lesions_of(model_.mesh, bound_lesions_, *examined_.error, registration_);
    take_errors();
    auto findings = examine({model_, cloud_, registration_, shapes_ ? &*shapes_ : nullptr, *examined_.error,
                             options_.start != Start::none},
                            context_.quiet());
    if (!findings) return false;
    examined_.findings = *findings;
    examined_.findings.elsewhere = elsewhere(registration_.nodes_in_camera, rivals);
    for (const LesionError& lesion : examined_.lesions)
      examined_.findings.lesions.push_back({structure_name(lesion.lesion), lesion.expected});
    if (is_sought() && shapes_) {
      const auto cost = control_.cost(model_, cloud_, options_, elastic_, up_to(1.0));
      if (!cost) return false;
      examined_.findings.mirror_odds = 0.5 * (*cost - shapes_->best().cost);
    }
    if (cloud_.look_count() > 1)
      result().look_distances = distances_of_looks(model_, registration_.nodes_in_camera, cloud_);
    examined_.findings.looks_differ = looks_differ_;
    tell(judge(examined_.findings));
    // Around a place that is contradicted there is nothing to look for.
    if (!is_refused(registration_))
      registration_.looks = looks_of(model_, cloud_, registration_, *examined_.error, context_.quiet());
    if (has_own_errors()) size_looks(examined_.lesions, registration_.looks);
    if (context_.cancelled()) return false;
    tell_of_places(std::move(rivals));
    result().displacement =
        point_errors(registration_.nodes_in_camera, registration_.camera_from_ct.apply(model_.mesh.vertices));
    result().registration = std::move(registration_);
    return true;
  }

  /// Whether the found forces' posterior tells the errors.
  bool has_own_errors() const { return examined_.registered.forces && !elastic_.prior && knows_pose(); }

  /// What is expected of nodes and lesions. Where supports are known and forces were found, their own
  /// posterior is the nearer one. It takes the pose for known.
  void take_errors() {
    const std::optional<ContactForceFit>& forces = result().forces;
    const bool has_own = has_own_errors();
    registration_.expected = has_own ? forces->expected_error : examined_.error->expected();
    registration_.covariances = examined_.error->node_covariances();
    if (has_own && forces->expected_error.size() == registration_.covariances.rows()) {
      sized_as(forces->expected_error, registration_.covariances);
      size_lesions(model_.mesh, bound_lesions_, forces->expected_error, examined_.lesions);
    } else if (has_own) {
      registration_.covariances.resize(0, 6);  // not known, as the expected errors
      examined_.lesions.clear();
    }
  }

  /// What travels with the registration of where it may be wrong.
  void tell_of_places(std::vector<RegistrationRival> rivals) {
    for (const LesionError& lesion : examined_.lesions)
      registration_.lesions.push_back({lesion.lesion, lesion.covariance});
    registration_.forks = forks_of(model_, registration_, *examined_.error);
    registration_.rivals = plausible_rivals(std::move(rivals));
    if (result().forces) registration_.forces = found_forces(*result().forces);
  }

  void tell(const Verdict& verdict) {
    std::vector<std::string>& doubts = registration_.doubts;
    doubts.insert(doubts.begin(), start_.doubts.begin(), start_.doubts.end());
    doubts.insert(doubts.end(), options_.model_doubts.begin(), options_.model_doubts.end());
    doubts.insert(doubts.end(), verdict.doubts.begin(), verdict.doubts.end());
    if (verdict.refused) doubts.insert(doubts.begin(), kRefused);
    tell_once(doubts);
  }

  const PatientModel& model_;
  LabelledCloud cloud_;  ///< with all looks
  RegisterOptions options_;
  const KnownOperations& known_;
  const RunContext& context_;
  ElasticOptions elastic_;
  double done_ = 0.0;
  RigidStart start_;
  std::vector<ShapeStart> starts_;
  std::vector<LabelledCloud> looks_;  ///< the cloud's own first; empty: there is one
  LookMotions into_first_;
  double looks_differ_ = std::numeric_limits<double>::quiet_NaN();  ///< not asked
  std::optional<ShapeFits> shapes_;
  Registration registration_;
  ExaminedRegistration examined_;
  BoundLesions bound_lesions_;
  MirrorControl control_;
};

}  // namespace

Cancellable<ExaminedRegistration> register_model(const PatientModel& model, const LabelledCloud& cloud,
                                                 const RegisterOptions& options, const RunContext& context,
                                                 const KnownOperations& known) {
  options.validate();
  return Run(model, cloud, options, known, context).run();
}

}  // namespace glisson::registration
