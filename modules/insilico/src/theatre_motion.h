// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/rigid.h"
#include "glisson/insilico/theatre.h"
#include "glisson/patient/patient_model.h"
#include "theatre_loads.h"

namespace glisson::insilico {

/// What a tool does to the liver: displacements of the nodes at equal steps of its way, CT's frame, metres.
struct ToolPull {
  std::vector<Points> steps;  ///< the first is zero
  double force_n = 0.0;       ///< at the end
  /// @param share of the way, 0 to 1.
  Points at(double share) const;
};

/// Where the theatre's liver is at any time, in the CT's frame: quasi-static equilibria of a Neo-Hookean
/// liver under gas, tilt and the push of the diaphragm, with smooth interpolation between them.
class TheatreMotion {
 public:
  /// @param landmarks where the vena cava holds and the ligament runs; what is missing is found by a rule.
  /// @throws NumericalError when no load reaches the required motion.
  static Cancellable<TheatreMotion> solve(const TetMesh& mesh, const std::vector<VesselTree>& vessels,
                                          const Landmarks& landmarks, const TheatreOptions& options,
                                          const RunContext& context);

  Points positions(double seconds) const;
  /// Equilibria under all that holds the liver at expiration and springs around `touched`, which a tool takes
  /// along.
  /// @param mesh, vessels, landmarks, options as for solve(). @param touched of the rest shape, on its
  ///   surface; @param way of the tip, as the liver lies in frame 0; CT's frame, metres.
  /// @return empty: cancelled. @throws NumericalError it cannot be taken so far.
  Cancellable<ToolPull> pull(const TetMesh& mesh, const std::vector<VesselTree>& vessels,
                             const Landmarks& landmarks, const TheatreOptions& options,
                             const Eigen::Vector3d& touched, const Eigen::Vector3d& way, double around,
                             const RunContext& context) const;
  /// @param inspired 0 (expiration) to 1. @param beat 0 to 1.
  Points at(double inspired, double beat) const;
  const TheatreFigures& figures() const { return figures_; }

 private:
  std::vector<Points> breath_;  ///< equilibria at equal steps of inspiration, 0 to 1
  Points heart_;                ///< displacement at the height of the beat
  double breathing_period_ = 4.0, heartbeat_period_ = 0.9;
  Points base_;  ///< expiration, before the change of posture
  LoadLevels levels_;
  Rigid<CtFrame, CtFrame> posture_;
  TheatreFigures figures_;
};

/// Share of inspiration in [0, 1]: 0 at time 0, with a rest at expiration (Lujan 1999).
double inspiration(double seconds, double period);
/// Share of the beat in [0, 1], 0 at time 0.
double heartbeat(double seconds, double period);

/// Mean distance of the nodes from the rest shape, and what remains of it after the best rigid alignment.
struct MeanMotion {
  double total = 0.0, elastic = 0.0;  ///< metres
};
MeanMotion mean_motion(const Points& rest, const Points& moved);

}  // namespace glisson::insilico
