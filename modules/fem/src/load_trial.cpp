// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/load_trial.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/stopwatch.h"
#include "glisson/fem/integrator.h"

namespace glisson::fem {
namespace {

/// Nearer than this to its rest shape, metres, an organ that nobody pulls is put there and needs no steps.
constexpr double kAtRest = 1e-5;
/// No liver goes further, metres: the step has diverged.
constexpr double kFurthest = 0.5;

IntegratorOptions integration(const TrialOptions& options, int tetrahedra) {
  IntegratorOptions made;
  made.time_step = options.time_step;
  made.solver = tetrahedra < options.fast_from ? LinearSolver::direct : LinearSolver::fast;
  return made;
}

class ElasticTrial : public LoadTrial {
 public:
  ElasticTrial(const std::shared_ptr<const CompositeModel>& composite, Holding holding,
               const TrialOptions& options)
      : composite_(composite),
        holding_(std::move(holding)),
        options_(options),
        integrator_(composite, integration(options, composite->mesh().tetrahedron_count())) {}

  TrialState step(const std::optional<TrialPull>& pull) override {
    const Stopwatch watch;
    lead_target(pull);
    Loads loads;
    hold(loads);
    if (pull) loads.attached.push_back(pulled(*pull));
    const StepSummary summary = integrator_.step(loads);
    TrialState state;
    state.tetrahedra = composite_->mesh().tetrahedron_count();
    state.pull = pull;
    state.residual = summary.residual;
    describe(summary, pull, state);
    state.milliseconds = watch.milliseconds();
    return state;
  }

 private:
  /// What holds is damped like the tissue (Rayleigh, r_K k): -r_K k v of the step's own velocity is a
  /// tangent r_K k / dt without a force.
  void hold(Loads& loads) const {
    holding_(integrator_.positions(), loads.attached);
    const double damped = 1.0 + composite_->options().rayleigh_stiffness / options_.time_step;
    for (AttachedLoad& held : loads.attached) held.tangent *= damped;
  }

  /// What pulls starts at the point that is grabbed and follows the pull's target no faster than allowed.
  void lead_target(const std::optional<TrialPull>& pull) {
    const bool same = pull && led_ && pull->triangle == led_->triangle && pull->weights == led_->weights;
    if (pull && !same) lead_ = grabbed(*pull);
    led_ = pull;
    if (!pull) return;
    const Eigen::Vector3d way = pull->target - lead_;
    const double reach = options_.target_speed * options_.time_step, length = way.norm();
    lead_ = length <= reach ? pull->target : Eigen::Vector3d(lead_ + way * (reach / length));
  }

  std::array<int, 3> corners(const TrialPull& pull) const {
    const BoundarySurface& skin = composite_->surface();
    std::array<int, 3> nodes{};
    for (int k = 0; k < 3; ++k)
      nodes[static_cast<std::size_t>(k)] =
          skin.node_of_vertex[static_cast<std::size_t>(skin.mesh.triangles(pull.triangle, k))];
    return nodes;
  }

  Eigen::Vector3d grabbed(const TrialPull& pull) const {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    const std::array<int, 3> nodes = corners(pull);
    for (std::size_t k = 0; k < 3; ++k)
      p += pull.weights[static_cast<Eigen::Index>(k)] * integrator_.positions().row(nodes[k]).transpose();
    return p;
  }

  Eigen::Vector3d pull_force(const TrialPull& pull) const {
    const Eigen::Vector3d way = lead_ - grabbed(pull);
    const double newton = options_.pull_stiffness * way.norm();
    return newton <= options_.pull_limit ? Eigen::Vector3d(options_.pull_stiffness * way)
                                         : Eigen::Vector3d(options_.pull_limit * way.normalized());
  }

  /// A spring up to the limit; beyond it a force of that size whose direction alone changes.
  AttachedLoad pulled(const TrialPull& pull) const {
    AttachedLoad load;
    const std::array<int, 3> nodes = corners(pull);
    for (std::size_t k = 0; k < 3; ++k) {
      load.nodes[k] = nodes[k];
      load.weights[k] = pull.weights[static_cast<Eigen::Index>(k)];
    }
    load.force = pull_force(pull);
    const Eigen::Vector3d way = lead_ - grabbed(pull);
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    if (options_.pull_stiffness * way.norm() <= options_.pull_limit) {
      load.tangent = options_.pull_stiffness * identity;
    } else {
      const Eigen::Vector3d along = way.normalized();
      load.tangent = options_.pull_limit / way.norm() * (identity - along * along.transpose());
    }
    return load;
  }

  void describe(const StepSummary& summary, const std::optional<TrialPull>& pull, TrialState& state) {
    const Points& rest = composite_->mesh().vertices;
    const double moved = (integrator_.positions() - rest).rowwise().norm().maxCoeff();
    if (!summary.ok || !(moved < kFurthest)) {
      state.termination = Termination::diverged;
    } else if (summary.inverted_tetrahedra > 0) {
      state.termination = Termination::diverged;
      state.inverted_tetrahedra = summary.inverted_tetrahedra;
    } else if (!pull && moved < kAtRest &&
               integrator_.velocities().rowwise().norm().maxCoeff() * options_.time_step < kAtRest) {
      integrator_.set_state(rest);
    } else {
      state.nodes = integrator_.positions();
      state.displacement_max = moved;
    }
    if (!pull || state.termination) return;
    state.grabbed = grabbed(*pull);
    state.force = pull_force(*pull);
  }

  std::shared_ptr<const CompositeModel> composite_;
  Holding holding_;
  TrialOptions options_;
  Integrator integrator_;
  Eigen::Vector3d lead_ = Eigen::Vector3d::Zero();  ///< what pulls, on its way to the target
  std::optional<TrialPull> led_;                    ///< that it belongs to
};

}  // namespace

void TrialOptions::validate() const {
  materials.validate();
  const OptionCheck demand("trial options");
  demand(time_step >= 1e-3 && time_step <= 0.1, "time_step", time_step, "Give a number from 0.001 to 0.1 s");
  demand(pull_stiffness > 0.0 && pull_stiffness <= 1e5, "pull_stiffness", pull_stiffness,
         "Give a positive number up to 1e5 N/m");
  demand(pull_limit > 0.0 && pull_limit <= 100.0, "pull_limit", pull_limit,
         "Give a positive number up to 100 N");
  demand(target_speed > 0.0 && target_speed <= 10.0, "target_speed", target_speed,
         "Give a positive number up to 10 m/s");
  demand(boundary_young_modulus > 0.0, "boundary_young_modulus", boundary_young_modulus,
         "Give a positive number");
  demand(boundary_length > 0.0, "boundary_length", boundary_length, "Give a positive length in metres");
  demand(fast_from >= 0, "fast_from", fast_from, "Give a number from zero");
}

void TrialPull::require_on_surface(int triangles) const {
  require(triangle >= 0 && triangle < triangles, "a pull takes hold of a triangle of the model's surface");
  require(weights.allFinite() && weights.minCoeff() >= -1e-9 && std::abs(weights.sum() - 1.0) < 1e-6,
          "a pull's weights are not negative and their sum is 1");
  require(target.allFinite(), "a pull's target is finite");
}

bool is_held(const PatientModel& model) {
  constexpr double kOffTheLine = 3e-3;  // m, root mean square
  std::vector<Eigen::RowVector3d> places;
  for (Eigen::Index i = 0; i < model.landmarks.vena_cava.rows(); ++i)
    places.emplace_back(model.landmarks.vena_cava.row(i));
  for (const VesselTree& tree : model.vessels)
    if (tree.root >= 0 && tree.root < tree.nodes.rows()) places.emplace_back(tree.nodes.row(tree.root));
  if (places.size() < 3) return false;
  Points points(static_cast<Eigen::Index>(places.size()), 3);
  for (std::size_t i = 0; i < places.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = places[i];
  const Points about = points.rowwise() - points.colwise().mean();
  const Eigen::Matrix3d spread = about.transpose() * about / static_cast<double>(points.rows());
  const Eigen::Vector3d variances =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  return variances[0] + variances[1] > kOffTheLine * kOffTheLine;
}

std::unique_ptr<LoadTrial> make_load_trial(const std::shared_ptr<const CompositeModel>& composite,
                                           Holding holding, const TrialOptions& options) {
  options.validate();
  return std::make_unique<ElasticTrial>(composite, std::move(holding), options);
}

Cancellable<std::unique_ptr<LoadTrial>> make_load_trial(const PatientModel& model, const Tissue& tissue,
                                                        const std::function<Holding()>& hold,
                                                        const TrialOptions& options,
                                                        const RunContext& context) {
  options.validate();
  if (model.mesh.tetrahedron_count() == 0)
    throw InputError("model", "mesh", "has no tetrahedra", "Build the model again");
  Holding holding = hold();
  if (!is_held(model))
    throw InputError(
        "model", "vena cava",
        "and the places where vessels enter lie on one line, about which the organ would turn freely",
        "Place three points or more of the vena cava among the landmarks, where it touches the liver");
  context.progress(0.1, "trial.model");
  const auto composite = std::make_shared<const CompositeModel>(
      model.mesh, model.vessels, with_tissue(options.materials, tissue, model.mesh));
  if (context.cancelled()) return {};
  context.progress(0.5, "trial.solver");
  auto trial = std::make_unique<ElasticTrial>(composite, std::move(holding), options);
  if (context.cancelled()) return {};
  return trial;
}

}  // namespace glisson::fem
