// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/fem/composite_model.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/operation_prior.h"
#include "glisson/registration/shape_fit.h"

namespace glisson::registration {

/// How the rigid start is sought.
struct RigidOptions {
  int starts = 200;            ///< seeded orientations tried
  double outlier_share = 0.1;  ///< of the points that are farthest off, left out of each fit, in [0, 0.9)
  int threads = 2;             ///< 1 or 2: the same bits
  /// The model lies in its CT's frame as the patient does, and the camera is a laparoscope: it stands before
  /// or below the liver, neither behind nor above it. Poses that say otherwise come after all others.
  bool from_cavity = false;
  /// @throws InputError naming the option.
  void validate() const;
};

/// How eq. 14 is read; see "Method" in the README. `corrected`: f = k w(s d)(p - q), w(x) = 1 - (2/pi) atan
/// x: a spring at contact, saturating far away. `clamped`: the printed magnitude where it attracts, zero
/// beyond s d = tan 1. `printed`: literally, from the cloud to the model. The last two are forces over a
/// stiffness, so they are scaled by the length 1/s; they are kept for the comparison only.
enum class PenaltyForm { corrected, clamped, printed };

/// Schedule of eq. 15. Factors are in metres: k = factor * E of the parenchyma.
struct ElasticOptions {
  PenaltyForm form = PenaltyForm::corrected;
  double s = 20.0;  ///< 1/m; chosen in silico
  double k_notch = 1e-3, k_margin_min = 1e-4, k_margin_max = 1e-3, k_surface_min = 0.0, k_surface_max = 1e-3;
  int r_margin = 2, r_surface = 10;
  double reference_density_per_cm2 = 3.9;
  /// After eq. 15's last plateau every k is multiplied by this, and one more plateau is waited for: springs
  /// in balance with the tissue end before the cloud, the stiffer the nearer. 1: the paper's method.
  double final_stiffening = 10.0;
  /// Share of k that resists sliding along the surface, in [0, 1]; 1: eq. 14's isotropic spring.
  double tangential = 0.1;
  int max_steps = 2000;
  double time_step = 0.1;  ///< s; the end does not depend on it
  /// A plateau: over `plateau_window` steps the mean residual has changed by less than this share (of itself,
  /// plus a tenth of a millimetre), and the kinetic energy is that of steps under `plateau_motion` metres.
  double plateau_change = 0.01, plateau_motion = 5e-5;
  int plateau_window = 4;
  std::vector<int> fixed_nodes;  ///< stay where the rigid start puts them
  fem::CompositeOptions materials;
  /// What operations do to this patient's liver. Null: the paper's method, elasticity alone. With a prior,
  /// pose and shape are fitted first, and the elastic stages start from that shape as one that is free of
  /// stress: the loads that made it go on holding it.
  std::shared_ptr<const OperationPrior> prior;
  ShapeFitOptions shape;
  /// @throws InputError naming the option.
  void validate() const;
};

/// The defaults for a model. One that is a bare mesh (no vessels, and no landmarks that a person placed; a
/// margin that was detected on a mesh says nothing of its material) is taken for homogeneous: no capsule, and
/// the paper's schedule without the final stiffening, its springs isotropic.
ElasticOptions options_for(const PatientModel& model, bool landmarks_are_placed = true);

/// A model whose rest shape is `nodes`: its tetrahedra, and the vessels bound to them. It stands for an organ
/// that is held there by the loads that brought it there. Constant nodal forces could hold it as well, but
/// would not turn with it and would tip it over. @param nodes N x 3, metres, any one frame.
PatientModel moved_to(const PatientModel& model, const Points& nodes);

}  // namespace glisson::registration
