// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"
#include "glisson/registration/pairs.h"
#include "penalty.h"

namespace glisson::registration {
namespace {

/// A stage that neither rests nor ends is left after so many steps: a limit cycle of the pairing.
constexpr int kStageSteps = 80;

/// Watches for eq. 15's plateaus.
class Plateau {
 public:
  Plateau(const ElasticOptions& options, double mass) : options_(options), mass_(mass) {}

  void start() { residuals_.clear(), steps_ = 0, is_rest_ = true; }
  /// Whether the stage that was reached rests; false: it was left, going to and fro.
  bool is_rest() const { return is_rest_; }

  bool reached(double residual, double kinetic_energy) {
    ++steps_;
    residuals_.push_back(residual);
    const auto window = static_cast<std::size_t>(options_.plateau_window);
    if (residuals_.size() > window + 1) residuals_.pop_front();
    is_rest_ = rests(residual, kinetic_energy, window);
    return is_rest_ || steps_ >= kStageSteps;
  }

 private:
  bool rests(double residual, double kinetic_energy, std::size_t window) const {
    if (residuals_.size() <= window) return false;
    const double motion = std::sqrt(2.0 * kinetic_energy / mass_) * options_.time_step;
    const double change = std::abs(residuals_.back() - residuals_.front());
    return motion < options_.plateau_motion && change < options_.plateau_change * (residual + 1e-4);
  }

  const ElasticOptions& options_;
  double mass_;
  std::deque<double> residuals_;
  int steps_ = 0;
  bool is_rest_ = true;
};

/// One registration while it runs.
class ElasticRun {
 public:
  /// @param rest the model in the shape in which it is free of stress, CT frame; `start` puts that shape
  /// before the camera. The surface and its landmarks are bound to the model as it is in the CT.
  ElasticRun(const PatientModel& model, const PatientModel& rest, const LabelledCloud& cloud,
             const CameraFromCt& start, const ElasticOptions& options)
      : options_(options),
        cloud_(prepare_cloud(cloud, {options.reference_density_per_cm2})),
        surface_(model, SurfaceDetail::fine),
        composite_(std::make_shared<fem::CompositeModel>(rest.mesh, rest.vessels, options.materials)),
        integrator_(composite_, integrator_options()),
        plateau_(options, composite_->lumped_mass().sum()) {
    integrator_.set_state(start.apply(rest.mesh.vertices));
    registration_.camera_from_ct = start;
    pair();
  }

  /// @throws InputError hardly anything of the cloud finds a place on the model: there is nothing to follow.
  Cancellable<Registration> run(const RunContext& context) {
    constexpr double kLeastMet = 0.1;  // of the points
    const auto met = std::count_if(pairs_.begin(), pairs_.end(), [](const Pair& pair) { return pair.kept; });
    if (static_cast<double>(met) <
        std::max<double>(kMinimumPoints, kLeastMet * static_cast<double>(pairs_.size())))
      throw InputError("cloud", "points",
                       "meet nothing of the model: they lie elsewhere, or their normals point away",
                       "Give a start that is nearer, or the cloud without normals");
    const int last = std::max(options_.r_margin, options_.r_surface) + 1;
    const int stages = last + (options_.final_stiffening > 1.0 ? 1 : 0);
    for (int n = 0; n < stages; ++n) {
      plateau_.start();
      bool rest = !pulls(n);
      while (!rest) {
        if (context.cancelled()) return std::nullopt;
        if (registration_.steps == options_.max_steps) return finish(Termination::step_limit);
        context.progress(static_cast<double>(n) / stages, "registration.elastic");
        if (!step(n, last)) return finish(Termination::diverged);
        rest = plateau_.reached(mean_distance(pairs_), kinetic_energy_);
      }
      registration_.plateaus = n + 1;
    }
    context.progress(1.0, "registration.elastic");
    return finish(plateau_.is_rest() ? Termination::converged : Termination::stalled);
  }

 private:
  fem::IntegratorOptions integrator_options() const {
    fem::IntegratorOptions options;
    options.time_step = options_.time_step;
    options.fixed_nodes = options_.fixed_nodes;
    return options;
  }

  void pair() {
    surface_.move(integrator_.positions());
    pairs_ = find_pairs(cloud_, surface_, {}, pairs_);
  }

  double factor(Feature feature, int n, int last) const {
    return (n < last ? 1.0 : options_.final_stiffening) * scheduled(feature, n);
  }

  double scheduled(Feature feature, int n) const {
    switch (feature) {
      case Feature::umbilical_notch:
        return options_.k_notch;
      case Feature::anterior_margin:
        return stiffness_at_plateau(options_.k_margin_min, options_.k_margin_max, options_.r_margin, n);
      case Feature::surface:
        break;
    }
    return stiffness_at_plateau(options_.k_surface_min, options_.k_surface_max, options_.r_surface, n);
  }

  /// Whether anything pulls at plateau n: with no labelled feature eq. 15 starts from nothing.
  bool pulls(int n) const {
    return std::any_of(pairs_.begin(), pairs_.end(),
                       [&](const Pair& pair) { return pair.kept && factor(pair.feature, n, n + 1) > 0.0; });
  }

  bool step(int n, int last) {
    const double modulus = options_.materials.parenchyma.young_modulus;
    fem::Loads loads;
    loads.attached.reserve(pairs_.size());
    for (const Pair& pair : pairs_) {
      const double k = factor(pair.feature, n, last) * modulus *
                       cloud_.weight[static_cast<std::size_t>(pair.point)] *
                       landmark_share(pair.feature, pair.deviation);
      if (pair.kept && k > 0.0)
        loads.attached.push_back(
            pair_load(pair, surface_, options_.form, options_.s, k, options_.tangential));
    }
    const fem::StepSummary summary = integrator_.step(loads);
    if (!summary.ok) return false;
    inverted_ = summary.inverted_tetrahedra;
    kinetic_energy_ = summary.kinetic_energy;
    ++registration_.steps;
    pair();
    return true;
  }

  Registration finish(Termination termination) {
    registration_.termination = termination;
    registration_.nodes_in_camera = integrator_.positions();
    registration_.residual = mean_distance(pairs_);
    registration_.seen_share = seen_share(surface_.mesh(), cloud_.cloud.points);
    int margin = 0, kept = 0;
    for (const Pair& pair : pairs_) {
      margin += pair.feature == Feature::anterior_margin;
      kept += pair.kept;
    }
    auto& doubts = registration_.doubts;
    if (margin < 5 || !surface_.has(Feature::anterior_margin)) doubts.emplace_back("few_margin_points");
    if (registration_.seen_share < kLittleSeen) doubts.emplace_back("little_surface_seen");
    if (kept < 0.8 * static_cast<double>(pairs_.size())) doubts.emplace_back("many_outliers");
    if (registration_.residual > kLargeResidual) doubts.emplace_back("residual_large");
    if (inverted_ > 0) doubts.emplace_back("inverted_elements");
    if (termination == Termination::step_limit) doubts.emplace_back("pull_not_at_rest");
    if (termination == Termination::diverged) doubts.emplace_back("mechanics_failed");
    return registration_;
  }

  const ElasticOptions& options_;
  PreparedCloud cloud_;
  MovingSurface surface_;
  std::shared_ptr<const fem::CompositeModel> composite_;
  fem::Integrator integrator_;
  Plateau plateau_;
  std::vector<Pair> pairs_;
  Registration registration_;
  double kinetic_energy_ = 0.0;
  int inverted_ = 0;
};

}  // namespace

void ElasticOptions::validate() const {
  const OptionCheck demand("elastic options");
  demand(s > 0.0 && std::isfinite(s), "s", s, "Give a positive number");
  demand(k_notch >= 0.0, "k_notch", k_notch, "Give a number from zero");
  demand(k_margin_min >= 0.0 && k_margin_min <= k_margin_max, "k_margin_min", k_margin_min,
         "Give a number from 0 to k_margin_max");
  demand(k_surface_min >= 0.0 && k_surface_min <= k_surface_max, "k_surface_min", k_surface_min,
         "Give a number from 0 to k_surface_max");
  demand(r_margin > 0, "r_margin", r_margin, "Give 1 or more");
  demand(r_surface > 0, "r_surface", r_surface, "Give 1 or more");
  demand(reference_density_per_cm2 > 0.0, "reference_density_per_cm2", reference_density_per_cm2,
         "Give a positive number");
  demand(final_stiffening >= 1.0, "final_stiffening", final_stiffening, "Give 1 or more");
  demand(tangential >= 0.0 && tangential <= 1.0, "tangential", tangential, "Give a share from 0 to 1");
  demand(max_steps > 0, "max_steps", max_steps, "Give 1 or more");
  demand(time_step > 0.0, "time_step", time_step, "Give a positive number of seconds");
  demand(plateau_change > 0.0, "plateau_change", plateau_change, "Give a positive number");
  demand(plateau_motion > 0.0, "plateau_motion", plateau_motion, "Give a positive length in metres");
  demand(plateau_window > 0, "plateau_window", plateau_window, "Give 1 or more");
  materials.validate();
  shape.validate();
}

ElasticOptions options_for(const PatientModel& model, bool landmarks_are_placed) {
  ElasticOptions options;
  if (model.vessels.empty() && (model.landmarks.empty() || !landmarks_are_placed)) {
    options.materials.with_capsule = false;
    options.final_stiffening = 1.0;
    options.tangential = 1.0;
  }
  return options;
}

PatientModel moved_to(const PatientModel& model, const Points& nodes) {
  PatientModel moved;
  moved.mesh = model.mesh;
  moved.mesh.vertices = nodes;
  moved.vessels = model.vessels;
  for (VesselTree& tree : moved.vessels)
    tree.nodes = bind_points(model.mesh, tree.nodes, false).apply(model.mesh, nodes);
  return moved;
}

namespace {

void check_fixed_nodes(const PatientModel& model, const ElasticOptions& options) {
  for (const int node : options.fixed_nodes)
    if (node < 0 || node >= model.mesh.vertex_count())
      throw InputError("fixed nodes", "node " + std::to_string(node),
                       "the mesh has nodes 0 to " + std::to_string(model.mesh.vertex_count() - 1),
                       "Give 0-based node numbers of this mesh");
}

/// A shape that the modes make, or less of it where they turn elements inside out. @param share of it.
Points sound_shape(const PatientModel& model, const OperationPrior& prior, const Eigen::VectorXd& amplitudes,
                   double& share) {
  constexpr double kThinnest = 0.02;  // volume over the one at rest
  const Eigen::VectorXd volumes = tetrahedron_volumes(model.mesh);
  TetMesh mesh = model.mesh;
  for (share = 1.0; share > 1e-3; share *= 0.8) {
    mesh.vertices = prior.shape(model.mesh.vertices, share * amplitudes);
    if ((tetrahedron_volumes(mesh).array() > kThinnest * volumes.array()).all()) return mesh.vertices;
  }
  share = 0.0;
  return model.mesh.vertices;
}

}  // namespace

Cancellable<Registration> register_elastic(const PatientModel& model, const LabelledCloud& cloud,
                                           const CameraFromCt& start, const ElasticOptions& options,
                                           const RunContext& context) {
  options.validate();
  check_fixed_nodes(model, options);
  require(!options.prior, "with a prior the shapes are fitted first, and it goes on from them");
  return ElasticRun(model, model, cloud, start, options).run(context);
}

Cancellable<Registration> register_elastic(const PatientModel& model, const LabelledCloud& cloud,
                                           const ShapeFits& shapes, const ElasticOptions& options,
                                           const RunContext& context) {
  options.validate();
  check_fixed_nodes(model, options);
  require(options.prior && !shapes.fits.empty(), "shapes rest on a prior, and there is one at least");
  const ShapeFit& fit = shapes.best();
  double share = 1.0;
  const PatientModel rest = moved_to(model, sound_shape(model, *options.prior, fit.amplitudes, share));
  auto registration = ElasticRun(model, rest, cloud, fit.camera_from_ct, options).run(context);
  if (!registration) return registration;
  auto& doubts = registration->doubts;
  doubts.insert(doubts.end(), shapes.doubts.begin(), shapes.doubts.end());
  if (share < 1.0) doubts.emplace_back("shape_inverted");
  return registration;
}

}  // namespace glisson::registration
