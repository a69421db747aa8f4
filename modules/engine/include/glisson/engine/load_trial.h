// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "glisson/core/run_context.h"
#include "glisson/core/termination.h"
#include "glisson/engine/case_state.h"
#include "glisson/fem/composite_model.h"

/// @file
/// A load tried on the patient's model, live: a point of the surface is pulled and the organ follows. It is a
/// trial: nothing of the case changes.

namespace glisson::engine {

/// The mechanics of a trial and what pulls.
struct TrialOptions {
  fem::CompositeOptions materials;
  double time_step = 1.0 / 60.0;  ///< s, of the mechanics; Engine::Options::trial_seconds is the pace
  double pull_stiffness = 600.0;  ///< N/m, of the spring from the grabbed point to its target
  double pull_limit = 6.0;        ///< N: the spring pulls no stronger, however far away its target is
  /// m/s at which what pulls moves towards its target. A jump of the pointer is no blow.
  double target_speed = 0.4;
  /// Vena cava and tree entrances as in the tracking, but with fixed ends (the paper's): k = E A / L.
  double boundary_young_modulus = 20e6;  ///< Pa
  double boundary_length = 0.05;         ///< m
  /// From so many tetrahedra on LinearSolver::fast is faster than LinearSolver::direct (see fem's README).
  int fast_from = 3000;
  /// @throws InputError naming the option.
  void validate() const;
};

/// A pull at a point of the model's surface.
struct TrialPull {
  int triangle = -1;                                  ///< of PatientModel::surface
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< of its vertices, not negative, sum 1
  Eigen::Vector3d target = Eigen::Vector3d::Zero();   ///< where the point is wanted, CT frame, metres
  bool operator==(const TrialPull&) const = default;
};

/// The trial after a step. Immutable once published.
struct TrialState {
  PointsIn<CtFrame> nodes;  ///< one row a node of the model, CT frame, metres; empty: at rest
  /// The pull that was applied, and the grabbed point where it now is (CT frame, metres).
  std::optional<TrialPull> pull;
  Eigen::Vector3d grabbed = Eigen::Vector3d::Zero();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N, on the grabbed point
  double displacement_max = 0.0;                    ///< m, of a node from its rest
  double residual = 0.0;                            ///< relative, of the step's linear system
  double milliseconds = 0.0;                        ///< of the step, by the clock on the wall
  double hertz = 0.0;                               ///< steps of the last second; 0: not known yet
  int steps = 0;                                    ///< since the trial began
  int tetrahedra = 0;
  /// How the trial ended by itself: no more steps are done and `nodes` is empty. Empty: it goes on.
  std::optional<Termination> termination;
  int inverted_tetrahedra = 0;  ///< that it ended for
};

/// The mechanics of a trial. One thread at a time.
class LoadTrial {
 public:
  virtual ~LoadTrial() = default;
  /// One step with this pull, or with none. `hertz` and `steps` are filled in by the engine.
  virtual TrialState step(const std::optional<TrialPull>& pull) = 0;
};

/// Implicit Euler on the composite model of the case, held at its vena cava and where its vessels enter; the
/// springs that hold it are damped like the tissue. Empty: cancelled.
/// @pre a model (the engine asks for what is in a command's way before).
/// @throws InputError a model without tetrahedra, nothing known that holds it, or only
/// places on one line, options out of range.
Cancellable<std::unique_ptr<LoadTrial>> make_load_trial(const CaseState& state, const TrialOptions& options,
                                                        const RunContext& context);

}  // namespace glisson::engine
