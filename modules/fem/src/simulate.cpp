// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/simulate.h"

#include <sstream>

#include "external_loads.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/stopwatch.h"
#include "glisson/fem/inverted.h"

namespace glisson::fem {
namespace {

/// What is left over of the forces on free nodes, relative to the external ones.
double force_residual(const CompositeModel& model, const AppliedLoad& load, const Points& x, double time) {
  Points external = Points::Zero(x.rows(), 3);
  add_external_force(model.impl(), load.at(x, time), x, external);
  Points sum = model.internal_force(x) + external;
  Points held = Points::Zero(x.rows(), 3);
  for (const int node : load.fixed_nodes()) {
    held.row(node) = sum.row(node);
    sum.row(node).setZero();
    external.row(node).setZero();
  }
  // Where nothing but moved nodes loads the organ: what holds them.
  const double reference = external.norm() > 0.0 ? external.norm() : held.norm();
  return reference > 0.0 ? sum.norm() / reference : sum.norm();
}

void describe(const CompositeModel& model, const Points& x, SimulationRecord& record) {
  const Eigen::VectorXd moved = (x - model.mesh().vertices).rowwise().norm();
  record.elastic_energy = model.energy(x);
  record.displacement_mean = moved.mean();
  record.displacement_max = moved.maxCoeff();
  record.von_mises_max = model.von_mises(x).maxCoeff();
}

Cancellable<SimulationResult> simulate_static(
    const CompositeModel& model, const AppliedLoad& load, const SimulationOptions& options,
    const RunContext& context, const std::function<void(const SimulationRecord&, const Points&)>& on_step) {
  if (!load.holds())
    throw InputError("load", "fixed", "is missing: nothing holds the model in a static solve",
                     "Fix nodes or attach springs to it");
  StaticOptions held;
  held.max_iterations = options.max_iterations;
  held.tolerance = options.tolerance;
  held.fixed_nodes = load.fixed_nodes();
  const Stopwatch watch;
  auto solution = solve_static(
      model, load.start(model), [&](const Points& x) { return load.at(x); }, held, context);
  if (!solution) return std::nullopt;
  SimulationRecord record;
  record.milliseconds = watch.milliseconds();
  record.step = solution->iterations;
  describe(model, solution->positions, record);
  record.force_residual = solution->residual;
  record.inverted_tetrahedra = inverted_tetrahedra(model, solution->positions);
  if (on_step) on_step(record, solution->positions);
  return SimulationResult{{record}, std::move(solution->positions), solution->termination};
}

}  // namespace

void SimulationOptions::validate() const {
  if (steps < 1 || steps > 1'000'000)
    throw InputError("simulation options", "steps", "is " + std::to_string(steps) + ", out of range",
                     "Give 1 to 1000000");
  if (max_iterations < 1)
    throw InputError("simulation options", "max_iterations",
                     "is " + std::to_string(max_iterations) + ", out of range", "Give 1 or more");
  if (!(solver_tolerance >= 1e-12 && solver_tolerance <= 0.1))
    throw InputError("simulation options", "solver_tolerance",
                     "is " + std::to_string(solver_tolerance) + ", out of range",
                     "Give a relative residual between 1e-12 and 0.1");
  if (!(tolerance > 0.0))
    throw InputError("simulation options", "tolerance", "is not positive", "Give 1e-8 or so");
}

Cancellable<SimulationResult> simulate(
    const std::shared_ptr<const CompositeModel>& model, const LoadCase& load_case,
    const SimulationOptions& options, const RunContext& context,
    const std::function<void(const SimulationRecord&, const Points&)>& on_step) {
  require(model != nullptr, "a simulation needs a model");
  options.validate();
  const AppliedLoad load(load_case, *model);
  if (options.static_solve) return simulate_static(*model, load, options, context, on_step);
  IntegratorOptions integration;
  integration.time_step = options.time_step;
  integration.solver = options.solver;
  integration.tolerance = options.solver_tolerance;
  integration.fixed_nodes = load.fixed_nodes();
  Integrator integrator(model, integration);
  SimulationResult result;
  for (int n = 1; n <= options.steps; ++n) {
    if (context.cancelled()) return std::nullopt;
    context.progress(static_cast<double>(n - 1) / options.steps, "fem.step");
    SimulationRecord record;
    record.step = n;
    record.time = n * options.time_step;
    const Stopwatch watch;
    const StepSummary step = integrator.step(load.at(integrator.positions(), record.time));
    record.milliseconds = watch.milliseconds();
    if (!step.ok)
      throw NumericalError("Step " + std::to_string(n) +
                           " of the simulation failed: the system is not positive definite, the state not "
                           "finite or the fast solver not converged; take a shorter time step, a smaller "
                           "load or the direct solver.");
    record.kinetic_energy = step.kinetic_energy;
    record.solver_residual = step.residual;
    record.solver_iterations = step.iterations;
    record.inverted_tetrahedra = step.inverted_tetrahedra;
    describe(*model, integrator.positions(), record);
    record.force_residual = force_residual(*model, load, integrator.positions(), record.time);
    if (on_step) on_step(record, integrator.positions());
    result.records.push_back(record);
  }
  result.positions = integrator.positions();
  return result;
}

void write_simulation_csv(const std::filesystem::path& path, const std::vector<SimulationRecord>& records) {
  std::ostringstream text;
  text.precision(9);
  text << "step,time_s,elastic_energy_j,kinetic_energy_j,solver_residual,solver_iterations,"
          "force_residual,"
          "displacement_mean_mm,displacement_max_mm,von_mises_max_pa,inverted_tetrahedra,step_ms\n";
  for (const SimulationRecord& r : records)
    text << r.step << ',' << r.time << ',' << r.elastic_energy << ',' << r.kinetic_energy << ','
         << r.solver_residual << ',' << r.solver_iterations << ',' << r.force_residual << ','
         << 1e3 * r.displacement_mean << ',' << 1e3 * r.displacement_max << ',' << r.von_mises_max << ','
         << r.inverted_tetrahedra << ',' << r.milliseconds << '\n';
  write_file_atomically(path, text.str());
}

}  // namespace glisson::fem
