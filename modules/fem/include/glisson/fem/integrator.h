// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "glisson/core/codes.h"
#include "glisson/core/run_context.h"
#include "glisson/core/termination.h"
#include "glisson/fem/composite_model.h"

namespace glisson::fem {

/// How a step's linear system is solved. `reference`: CHOLMOD. `direct`: a factorisation of our own, afresh
/// every step. `fast`: conjugate gradients with a two-level preconditioner up to a tolerance, afresh every
/// step too (nothing lags), faster than `direct` from kFastFrom tetrahedra on.
enum class LinearSolver { reference, direct, fast };
/// Tetrahedra, about (packaging/figures/benchmarks.md).
inline constexpr int kFastFrom = 3000;
/// For the command line.
inline constexpr Codes<LinearSolver, 3> kSolverCodes = {
    {{"direct", LinearSolver::direct}, {"fast", LinearSolver::fast}, {"reference", LinearSolver::reference}}};

/// How time goes on in an Integrator.
struct IntegratorOptions {
  double time_step = 0.02;  ///< s
  LinearSolver solver = LinearSolver::direct;
  double tolerance = 1e-6;   ///< of `fast`: |b - A dx| <= tolerance |b|
  int max_iterations = 400;  ///< of `fast`; a step that needs more fails
  int threads = 2;           ///< of `direct`, 1 or 2: the same bits. A small matrix is left to one
  /// Nodes that do not move (0-based) unless a step's loads prescribe where they go.
  std::vector<int> fixed_nodes;

  /// @throws InputError naming the option.
  void validate() const;
};

/// What became of one step of time.
struct StepSummary {
  /// false: the matrix was not positive definite, the state not finite, or `fast` not converged; the state is
  /// unchanged.
  bool ok = true;
  double residual = 0.0;        ///< relative, of the linear solve
  int iterations = 0;           ///< of `fast`
  double kinetic_energy = 0.0;  ///< J, after the step
  int inverted_tetrahedra = 0;  ///< after the step: of negative volume
};

/// Implicit backward Euler (Baraff and Witkin 1998), one linear system a step: (M/dt2 + B/dt + K + K_ext) dx
/// = ... Symbolic analysis once, at construction. Not thread-safe. Same bits from run to run.
class Integrator {
 public:
  /// At the model's rest shape, at rest. @throws InputError options, fixed nodes that the model does not
  /// have.
  Integrator(std::shared_ptr<const CompositeModel> model, const IntegratorOptions& options);
  ~Integrator();
  Integrator(Integrator&&) noexcept;
  Integrator& operator=(Integrator&&) noexcept;

  const Points& positions() const;   ///< of the nodes, metres, in the frame of set_state()
  const Points& velocities() const;  ///< m/s, likewise
  /// Puts the model somewhere, at rest (its rest shape, rigidly moved, is a fine start: no force arises).
  void set_state(const Points& positions);
  void set_state(const Points& positions, const Points& velocities);
  void stop();  ///< velocities to zero

  /// @throws InputError for loads that do not fit, and prescribed nodes that are not fixed ones.
  StepSummary step(const Loads& loads);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How an equilibrium is looked for.
struct StaticOptions {
  int max_iterations = 200;
  /// The residual force over the external force (or a thousandth of its largest, where springs let go), in
  /// (0, 1); where there is none (nodes were only put elsewhere) over the force that holds the fixed nodes.
  double tolerance = 1e-8;
  std::vector<int> fixed_nodes;  ///< 0-based; they stay where the start has them
  int threads = 2;               ///< 1 or 2: the same bits

  /// @throws InputError naming the option.
  void validate() const;
};

/// The equilibrium that was found, or how far the search came.
struct StaticSummary {
  Points positions;  ///< of all nodes, in the start's frame, metres
  Termination termination = Termination::step_limit;
  int iterations = 0;
  double residual = 0.0;  ///< relative, as StaticOptions::tolerance; of these positions
  bool converged() const { return termination == Termination::converged; }
};

/// The equilibrium under loads that may depend on the shape: Newton with a line search on the energy.
/// @param start one row a node, metres. @param loads is asked again at every iterate.
/// @return empty: cancelled. A solve that has not converged is returned with its termination.
/// @throws InputError options, fixed nodes or loads that do not fit the model; NumericalError when nothing
/// holds the model (no fixed node, no attached load with a tangent).
Cancellable<StaticSummary> solve_static(const CompositeModel& model, const Points& start,
                                        const std::function<Loads(const Points&)>& loads,
                                        const StaticOptions& options, const RunContext& context);

}  // namespace glisson::fem
