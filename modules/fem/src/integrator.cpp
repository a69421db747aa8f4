// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/integrator.h"

#include <Eigen/Geometry>
#include <cmath>

#include "block_matrix.h"
#include "external_loads.h"
#include "factorization.h"
#include "glisson/core/error.h"
#include "glisson/fem/inverted.h"
#include "two_level_solver.h"

namespace glisson::fem {

void IntegratorOptions::validate() const {
  if (!(time_step >= 1e-6 && time_step <= 10.0))
    throw InputError("integrator options", "time_step",
                     "is " + std::to_string(time_step) + " s, out of range",
                     "Give a step between 1e-6 and 10 s");
  if (!(tolerance >= 1e-12 && tolerance <= 0.1))
    throw InputError("integrator options", "tolerance", "is " + std::to_string(tolerance) + ", out of range",
                     "Give a relative residual between 1e-12 and 0.1");
  if (max_iterations < 1)
    throw InputError("integrator options", "max_iterations",
                     "is " + std::to_string(max_iterations) + ", out of range", "Give 1 or more");
  if (threads < 1 || threads > 2)
    throw InputError("integrator options", "threads", "is " + std::to_string(threads) + ", out of range",
                     "Give 1 or 2");
}

struct Integrator::Impl {
  std::shared_ptr<const CompositeModel> model;
  IntegratorOptions options;
  BlockSystem system;
  std::unique_ptr<Factorization> factorization;
  std::unique_ptr<TwoLevelSolver> two_level;  ///< of `fast`, instead
  Points x, v;
  Points force;
  Points held_move;                    ///< of prescribed nodes in this step
  Points drag;                         ///< what that asks of the others; empty when none moves
  std::unique_ptr<BlockSystem> whole;  ///< of all nodes, made when held ones move first
  Eigen::VectorXd solution, right, product;

  Impl(std::shared_ptr<const CompositeModel> m, const IntegratorOptions& o)
      : model(std::move(m)),
        options(o),
        system(model->impl(), o.fixed_nodes, batch_kernels(),
               o.solver == LinearSolver::fast ? Ordering::breadth_first : Ordering::fill_reducing),
        x(model->mesh().vertices),
        v(Points::Zero(x.rows(), 3)) {
    if (o.solver == LinearSolver::fast)
      two_level = std::make_unique<TwoLevelSolver>(system.pattern(), x);
    else
      factorization = make_factorization(o.solver, system.pattern(), o.threads);
  }

  /// dx of the system that is assembled, into `solution`. @return false when it cannot be had.
  bool solve(StepSummary& summary) {
    if (!right.allFinite()) return false;
    if (two_level) {
      if (!two_level->prepare(system.values())) return false;
      solution = options.time_step * system.gather(v);  // as before: a good first guess
      const TwoLevelSolver::Result result =
          two_level->solve(right, solution, options.tolerance, options.max_iterations);
      summary.iterations = result.iterations;
      summary.residual = result.residual;
      return result.converged && solution.allFinite();
    }
    if (!factorization->factorise(system.values())) return false;
    solution = right;
    factorization->solve(solution);
    if (!solution.allFinite()) return false;
    system.multiply(solution, product);
    const double size = right.norm();
    summary.residual = size > 0.0 ? (right - product).norm() / size : 0.0;
    return true;
  }

  void assemble(BlockSystem& target, const Loads& loads);
  void prescribe(const Loads& loads);
};

Integrator::Integrator(std::shared_ptr<const CompositeModel> model, const IntegratorOptions& options) {
  require(model != nullptr, "an integrator needs a model");
  options.validate();
  impl_ = std::make_unique<Impl>(std::move(model), options);
}
Integrator::~Integrator() = default;
Integrator::Integrator(Integrator&&) noexcept = default;
Integrator& Integrator::operator=(Integrator&&) noexcept = default;

const Points& Integrator::positions() const { return impl_->x; }
const Points& Integrator::velocities() const { return impl_->v; }

void Integrator::set_state(const Points& positions) {
  set_state(positions, Points::Zero(positions.rows(), 3));
}

void Integrator::set_state(const Points& positions, const Points& velocities) {
  const auto n = impl_->model->node_count();
  require(positions.rows() == n && velocities.rows() == n, "a state holds one row a node of the model");
  require(positions.allFinite() && velocities.allFinite(), "a state is finite");
  impl_->x = positions;
  impl_->v = velocities;
  for (const int node : impl_->options.fixed_nodes) impl_->v.row(node).setZero();
}

void Integrator::stop() { impl_->v.setZero(); }

/// The system's matrix at x, and the forces on all nodes but what the velocities add.
void Integrator::Impl::assemble(BlockSystem& target, const Loads& loads) {
  const CompositeModel::Impl& m = model->impl();
  const CompositeOptions& o = m.options;
  const double dt = options.time_step;
  target.assemble(x, 1.0 + o.rayleigh_stiffness / dt, Tangent::rotated, force);
  target.add_mass(1.0 / (dt * dt) + o.rayleigh_mass / dt);
  add_external_tangent(m, loads, x, Tangent::rotated, target);
}

/// Where held nodes go in this step, and what that asks of the others: -A dx, which takes the couplings that
/// the system of the free nodes leaves out.
void Integrator::Impl::prescribe(const Loads& loads) {
  held_move.setZero(x.rows(), 3);
  for (const PrescribedNode& moved : loads.prescribed) {
    if (system.pattern().unknown_of_node[static_cast<std::size_t>(moved.node)] >= 0)
      throw InputError("loads", "prescribed node " + std::to_string(moved.node), "is free to move",
                       "Name it among the fixed nodes of the integrator");
    held_move.row(moved.node) = moved.position.transpose() - x.row(moved.node);
  }
  drag.resize(0, 3);
  if (held_move.isZero(0.0)) return;
  if (!whole)
    whole = std::make_unique<BlockSystem>(model->impl(), std::vector<int>(), batch_kernels(),
                                          Ordering::breadth_first);
  assemble(*whole, loads);
  whole->multiply(whole->gather(held_move), product);
  drag = whole->scatter(product);
}

StepSummary Integrator::step(const Loads& loads) {
  Impl& s = *impl_;
  const CompositeModel::Impl& model = s.model->impl();
  check_loads(model, loads);
  const double dt = s.options.time_step;
  StepSummary summary;
  s.prescribe(loads);
  // (M (1/dt2 + r_M/dt) + (1 + r_K/dt) K + K_ext) dx = M v / dt + f
  s.assemble(s.system, loads);
  add_external_force(model, loads, s.x, s.force);
  s.force += s.model->mass_times(s.v) / dt;
  if (s.drag.rows() > 0) s.force -= s.drag;
  s.right = s.system.gather(s.force);
  summary.ok = s.solve(summary);
  if (!summary.ok) return summary;
  const Points move = s.system.scatter(s.solution) + s.held_move;
  s.x += move;
  s.v = move / dt;
  // To the bit where they were sent.
  for (const PrescribedNode& moved : loads.prescribed) s.x.row(moved.node) = moved.position.transpose();
  summary.kinetic_energy = 0.5 * s.model->mass_times(s.v).cwiseProduct(s.v).sum();
  summary.inverted_tetrahedra = inverted_tetrahedra(*s.model, s.x);
  return summary;
}

}  // namespace glisson::fem
