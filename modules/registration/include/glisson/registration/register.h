// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/fem/composite_model.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"

namespace glisson::registration {

struct RigidOptions {
  int starts = 200;  ///< seeded orientations tried
  double outlier_share = 0.1;
  void validate() const;
};
struct RigidStart {
  CameraFromCt camera_from_ct;
  double residual = 0.0;  ///< metres, trimmed mean
  std::vector<std::string> doubts;
};
/// Rigid alignment from the labelled features, robust to a partial view and a wrong start.
/// @throws InputError fewer than 10 points.
Cancellable<RigidStart> align_rigid(const PatientModel& model, const LabelledCloud& cloud,
                                    const RigidOptions& options, const RunContext& context);

/// How eq. 14 is read; see METHOD in the README. `corrected`: f = k w(s d)(p - q), w(x) = 1 - (2/pi) atan x.
enum class PenaltyForm { corrected, clamped, printed };

/// Schedule of eq. 15. Factors are in metres: k = factor * E of the parenchyma.
struct ElasticOptions {
  PenaltyForm form = PenaltyForm::corrected;
  double s = 50.0;  ///< 1/m
  double k_notch = 1e-3, k_margin_min = 1e-4, k_margin_max = 1e-3, k_surface_min = 0.0, k_surface_max = 1e-3;
  int r_margin = 2, r_surface = 10;
  double reference_density_per_cm2 = 3.9;
  int max_steps = 2000;
  double time_step = 0.02;
  std::vector<int> fixed_nodes;  ///< stay where the rigid start puts them
  fem::CompositeOptions materials;
  void validate() const;
};

/// Initial elastic registration (paper 2.2.3; eq. 14 and 15 as METHOD corrects them): label-restricted
/// closest points, implicit Euler steps, plateaus of kinetic energy and mean residual, stop at max(r) + 1.
Cancellable<Registration> register_elastic(const PatientModel& model, const LabelledCloud& cloud,
                                           const CameraFromCt& start, const ElasticOptions& options,
                                           const RunContext& context);

/// eq. 15. @param n plateau index.
double stiffness_at_plateau(double k_min, double k_max, int r, int n);
/// Magnitude of eq. 14's force over k, at distance d (metres).
double penalty_force(PenaltyForm form, double s, double d);

}  // namespace glisson::registration
