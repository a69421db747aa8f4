// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/core/termination.h"
#include "glisson/fem/integrator.h"
#include "glisson/fem/loads_io.h"

namespace glisson::fem {

/// How a load is run.
struct SimulationOptions {
  int steps = 100;                             ///< of the dynamics
  double time_step = 0.02;                     ///< s
  LinearSolver solver = LinearSolver::direct;  ///< of the dynamics
  double solver_tolerance = 1e-6;              ///< of LinearSolver::fast, relative
  bool static_solve = false;                   ///< the equilibrium instead: one record
  int max_iterations = 300;                    ///< of the static solve
  double tolerance = 1e-8;                     ///< of the static solve

  /// @throws InputError naming the option.
  void validate() const;
};

/// One step of a simulation, or the static solution.
struct SimulationRecord {
  int step = 0;
  double time = 0.0;             ///< s
  double elastic_energy = 0.0;   ///< J
  double kinetic_energy = 0.0;   ///< J
  double solver_residual = 0.0;  ///< relative, of the linear system
  int solver_iterations = 0;     ///< of LinearSolver::fast
  double force_residual = 0.0;   ///< |internal + external force| on free nodes over |external|: 0 at rest
  double displacement_mean = 0.0, displacement_max = 0.0;  ///< m, from the rest shape
  double von_mises_max = 0.0;                              ///< Pa
  int inverted_tetrahedra = 0;
  double milliseconds = 0.0;  ///< of the step alone, by the clock on the wall
};

/// All steps, and where they end.
struct SimulationResult {
  std::vector<SimulationRecord> records;
  Points positions;  ///< of the nodes at the end, metres, the model's frame
  /// Of the static solve; a dynamic run that comes to its end has converged in every step.
  Termination termination = Termination::converged;
};

/// Runs a load on a model from its rest shape.
/// @param on_step given every record with its node positions, as they come (may be empty).
/// @throws InputError for loads that do not fit the model or that nothing holds in a static solve;
/// NumericalError when a step fails.
Cancellable<SimulationResult> simulate(
    const std::shared_ptr<const CompositeModel>& model, const LoadCase& load,
    const SimulationOptions& options, const RunContext& context,
    const std::function<void(const SimulationRecord&, const Points&)>& on_step = {});

/// A table with a header line, one record a line; units in the names. @throws FileError.
void write_simulation_csv(const std::filesystem::path& path, const std::vector<SimulationRecord>& records);

}  // namespace glisson::fem
