// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "block_matrix.h"
#include "external_loads.h"
#include "factorization.h"
#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"
#include "gmres.h"

namespace glisson::fem {
namespace {

bool holds(const Loads& loads, const StaticOptions& options) {
  if (!options.fixed_nodes.empty()) return true;
  for (const AttachedLoad& load : loads.attached)
    if (!load.tangent.isZero(0.0)) return true;
  return false;
}

/// Relative residual to which the unsymmetric system is solved: what Newton's last steps need.
constexpr double kNewtonTolerance = 1e-5;
constexpr int kNewtonIterations = 60;
constexpr int kLongestPenalty = 24;

class StaticSolve {
 public:
  StaticSolve(const CompositeModel& model, const std::function<Loads(const Points&)>& loads,
              const StaticOptions& options)
      : model_(model),
        loads_(loads),
        options_(options),
        system_(model.impl(), options.fixed_nodes),
        factorization_(make_factorization(LinearSolver::direct, system_.pattern(), options.threads)) {}

  Cancellable<StaticSummary> run(const Points& start, const RunContext& context) {
    StaticSummary summary;
    summary.positions = start;
    Loads loads = loads_(start);
    check_loads(model_.impl(), loads);
    if (!holds(loads, options_))
      throw NumericalError("Nothing holds the model in the static solve; fix nodes or attach springs to it.");
    double energy = model_.energy(start), shown = 0.0;
    external_ = external_force(start, loads);
    for (;; ++summary.iterations) {
      if (context.cancelled()) return std::nullopt;
      const Eigen::VectorXd residual = left_over(summary.positions);
      judge_exact(residual.norm());
      summary.residual = residual.norm() / reference(summary.positions);
      summary.termination = Termination::diverged;
      if (!std::isfinite(summary.residual)) return summary;
      shown = std::max(shown, progress(summary.residual));  // an exact step may raise what is left over
      context.progress(shown, "fem.static");
      if (summary.residual <= options_.tolerance) {
        summary.termination = Termination::converged;
        return summary;
      }
      if (summary.iterations == options_.max_iterations) {
        summary.termination = Termination::step_limit;
        return summary;
      }
      const Eigen::VectorXd direction = solve(summary.positions, loads, residual);
      if (!line_search(summary.positions, direction, residual, energy, loads)) return summary;
    }
  }

 private:
  Points external_force(const Points& x, const Loads& loads) const {
    Points force = Points::Zero(x.rows(), 3);
    add_external_force(model_.impl(), loads, x, force);
    return force;
  }

  Eigen::VectorXd left_over(const Points& x) const {
    return system_.gather(model_.internal_force(x) + external_);
  }

  /// Decides whether exact steps go on. They are judged two at a time: the first may raise the residual (a
  /// linear turn swells stiff elements), the second then removes nearly all of it. Where a pair does not pay,
  /// as far from the solution, projected steps follow for a while, longer each time.
  void judge_exact(double residual) {
    if (exact_steps_ == 0) before_exact_ = residual;
    if (exact_steps_ >= 2) {
      if (!(residual < 0.5 * before_exact_)) {
        penalty_ = std::min(2 * penalty_, kLongestPenalty);
        patience_ = penalty_;
      }
      exact_steps_ = 0;
      before_exact_ = residual;
    }
  }

  bool factorise(const Points& x, const Loads& loads, Tangent kind) {
    Points force;
    system_.assemble(x, 1.0, kind, force);
    add_external_tangent(model_.impl(), loads, x, kind, system_);
    return factorization_->factorise(system_.values());
  }

  /// Newton's step: with the exact derivative where its turn is (quadratic convergence at the end), else with
  /// the projected one, which always descends.
  Eigen::VectorXd solve(const Points& x, const Loads& loads, const Eigen::VectorXd& residual) {
    const bool try_exact = patience_ == 0;
    if (!try_exact) --patience_;
    if (try_exact && factorise(x, loads, Tangent::exact)) {
      ++exact_steps_;
      Eigen::VectorXd direction = residual;
      if (loads.pressure != 0.0)
        direction = newton_direction(system_.values(), x, loads, residual);
      else
        factorization_->solve(direction);
      return direction;
    }
    const std::vector<double> exact = try_exact ? system_.values() : std::vector<double>();
    factorise_projected(x, loads);
    if (try_exact) {
      // Not positive definite: still Newton's direction where that descends.
      Eigen::VectorXd direction = newton_direction(exact, x, loads, residual);
      if (direction.allFinite() && residual.dot(direction) > 0.0) {
        ++exact_steps_;
        return direction;
      }
      patience_ = penalty_;  // it costs a factorisation to find out: not every time
    }
    exact_steps_ = 0;
    Eigen::VectorXd direction = residual;
    factorization_->solve(direction);
    return direction;
  }

  /// Factorises the projected matrix; where that is singular (too few held nodes), with a multiple of the
  /// mass added.
  void factorise_projected(const Points& x, const Loads& loads) {
    bool done = factorise(x, loads, Tangent::projected);
    for (double shift = 1.0; !done; shift *= 10.0) {
      if (shift > 1e12) throw NumericalError("The static solve's matrix is singular; hold more nodes.");
      system_.add_diagonal(model_.lumped_mass(), shift);
      done = factorization_->factorise(system_.values());
    }
  }

  /// Solves with the force's whole derivative: `symmetric` (the exact tangents) and the part of the
  /// pressure's that is not symmetric, since pressure on a part of the surface has no potential. What is
  /// factorised differs from it by little (that part lives on the rim), so a few iterations do.
  Eigen::VectorXd newton_direction(const std::vector<double>& symmetric, const Points& x, const Loads& loads,
                                   const Eigen::VectorXd& residual) {
    const LinearMap matrix = [&](const Eigen::VectorXd& d, Eigen::VectorXd& product) {
      system_.multiply(symmetric, d, product);
      if (loads.pressure == 0.0) return;
      Points skew = Points::Zero(x.rows(), 3);
      add_pressure_skew_product(model_.impl(), loads, x, system_.scatter(d), skew);
      product += system_.gather(skew);
    };
    const LinearMap inverse = [&](const Eigen::VectorXd& r, Eigen::VectorXd& d) {
      d = r;
      factorization_->solve(d);
    };
    return gmres(matrix, inverse, residual, kNewtonTolerance, kNewtonIterations);
  }

  /// Armijo's rule on elastic energy less the loads' work along the step (trapezoid: springs and pressure
  /// change along it; a load need not have a potential). Near the solution, where that difference drowns in
  /// round-off, a smaller residual counts.
  bool line_search(Points& x, const Eigen::VectorXd& direction, const Eigen::VectorXd& residual,
                   double& energy, Loads& loads) {
    const double slope = residual.dot(direction);
    if (!(slope > 0.0)) return false;
    const double noise = 1e-13 * (std::abs(energy) + std::abs(slope));
    const double before = system_.gather(external_).dot(direction);
    double length = 1.0;
    for (int k = 0; k < 30; ++k, length *= 0.5) {
      const Points trial = x + length * system_.scatter(direction);
      const double trial_energy = model_.energy(trial);
      if (!std::isfinite(trial_energy)) continue;
      Loads trial_loads = loads_(trial);
      check_loads(model_.impl(), trial_loads);
      Points trial_external = external_force(trial, trial_loads);
      const double work = 0.5 * length * (before + system_.gather(trial_external).dot(direction));
      const double change = trial_energy - energy - work;
      bool accept = change <= -1e-4 * length * slope;
      if (!accept && std::abs(change) <= noise * 1e2)
        accept = system_.gather(model_.internal_force(trial) + trial_external).norm() < residual.norm();
      if (!accept) continue;
      x = trial;
      energy = trial_energy;
      loads = std::move(trial_loads);
      external_ = std::move(trial_external);
      return true;
    }
    return false;
  }

  /// The external force; where there is none (nodes were put elsewhere), what holds them. Springs that carry
  /// the organ as a whole let go of it in the end, and only rounding is left of both sides: then a thousandth
  /// of what they once pulled with counts.
  double reference(const Points& x) {
    constexpr double kLetGo = 1e-3;
    double size = system_.gather(external_).norm();
    largest_external_ = std::max(largest_external_, size);
    size = std::max(size, kLetGo * largest_external_);
    if (size == 0.0) size = model_.internal_force(x).norm();
    return std::max(size, 1e-12);
  }

  double progress(double residual) const {
    return std::clamp(std::log(residual) / std::log(options_.tolerance), 0.0, 1.0);
  }

  const CompositeModel& model_;
  const std::function<Loads(const Points&)>& loads_;
  const StaticOptions& options_;
  BlockSystem system_;
  std::unique_ptr<Factorization> factorization_;
  Points external_;
  double largest_external_ = 0.0;   ///< N, of all iterates
  int penalty_ = 3, patience_ = 3;  ///< projected steps before the exact derivative is tried
  int exact_steps_ = 0;             ///< in a row, since they were last judged
  double before_exact_ = 0.0;
};

}  // namespace

void StaticOptions::validate() const {
  const OptionCheck demand("static options");
  demand(max_iterations >= 1, "max_iterations", max_iterations, "Give 1 or more");
  demand(tolerance > 0.0 && tolerance < 1.0, "tolerance", tolerance,
         "Give a relative residual between 0 and 1");
  for (const int node : fixed_nodes) demand(node >= 0, "fixed_nodes", node, "Give 0-based node numbers");
  demand(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
}

Cancellable<StaticSummary> solve_static(const CompositeModel& model, const Points& start,
                                        const std::function<Loads(const Points&)>& loads,
                                        const StaticOptions& options, const RunContext& context) {
  options.validate();
  require(start.rows() == model.node_count(), "a start holds one row a node of the model");
  require(start.allFinite(), "a start is finite");
  return StaticSolve(model, loads, options).run(start, context);
}

}  // namespace glisson::fem
