// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/core/termination.h"
#include "glisson/fem/composite_model.h"
#include "glisson/fem/tissue.h"
#include "glisson/patient/patient_model.h"

/// @file
/// A load tried on a model, step by step: a point of the surface is pulled and the organ follows.

namespace glisson::fem {

/// The mechanics of a trial and what pulls.
struct TrialOptions {
  CompositeOptions materials;
  double time_step = 1.0 / 60.0;  ///< s, of the mechanics; the pace by the clock is the caller's
  double pull_stiffness = 600.0;  ///< N/m, of the spring from the grabbed point to its target
  double pull_limit = 6.0;        ///< N: the spring pulls no stronger, however far away its target is
  /// m/s at which what pulls moves towards its target. A jump of the pointer is no blow.
  double target_speed = 0.4;
  /// Vena cava and tree entrances as in the tracking, but with fixed ends (the paper's): k = E A / L.
  double boundary_young_modulus = 20e6;  ///< Pa
  double boundary_length = 0.05;         ///< m
  /// From so many tetrahedra on LinearSolver::fast is faster than LinearSolver::direct (see the README).
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
  /// @throws PreconditionError a triangle that is none of `triangles`, weights that are no place in it, a
  /// target that is not finite.
  void require_on_surface(int triangles) const;
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
  /// One step with this pull, or with none. `hertz` and `steps` are the caller's.
  virtual TrialState step(const std::optional<TrialPull>& pull) = 0;
};

/// Adds the loads of what holds the organ. @param nodes N x 3, one row a node, CT frame, metres.
using Holding = std::function<void(const Points& nodes, std::vector<AttachedLoad>& loads)>;

/// Whether the organ cannot turn freely about a line through the places that hold it: its vena cava, and
/// where its vessels enter.
bool is_held(const PatientModel& model);

/// Implicit Euler on a composite model. What holds it is damped like the tissue; what pulls is a spring whose
/// end follows the pull's target. @throws InputError options out of range.
std::unique_ptr<LoadTrial> make_load_trial(const std::shared_ptr<const CompositeModel>& composite,
                                           Holding holding, const TrialOptions& options);
/// The same on the composite model of a patient's liver, with what is said of its tissue.
/// @param hold makes what holds the liver; @throws InputError nothing does.
/// @return empty: cancelled.
/// @throws InputError options out of range, a model without tetrahedra, one that is not is_held().
Cancellable<std::unique_ptr<LoadTrial>> make_load_trial(const PatientModel& model, const Tissue& tissue,
                                                        const std::function<Holding()>& hold,
                                                        const TrialOptions& options,
                                                        const RunContext& context);

}  // namespace glisson::fem
