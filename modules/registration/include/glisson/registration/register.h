// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/fem/composite_model.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/shape_fit.h"

namespace glisson::registration {

/// How the rigid start is sought.
struct RigidOptions {
  int starts = 200;            ///< seeded orientations tried
  double outlier_share = 0.1;  ///< of the points that are farthest off, left out of each fit, in [0, 0.9)
  int threads = 2;             ///< 1 or 2: the same bits
  /// @throws InputError naming the option.
  void validate() const;
};
/// Where the model is before it is bent: CT frame to the left camera's, metres.
struct RigidStart {
  CameraFromCt camera_from_ct;
  double residual = 0.0;  ///< metres: trimmed mean distance of the cloud from the model
  /// Other poses that fit well, 10 mm and more from the start and from each other, the better first, four at
  /// most (and the one that was set by hand).
  std::vector<CameraFromCt> alternatives;
  std::vector<std::string> doubts;  ///< codes with values, see align_rigid
};
/// Rigid alignment from the labelled features, robust to a partial view and a wrong start: seeded starts,
/// trimmed label-restricted ICP, the better ones refined and judged along the camera's rays too. The camera
/// is at the origin of the cloud's frame. Doubts: few_margin_points, no_notch, rigid_residual_large,
/// rigid_ambiguous (another pose, 20 mm away on average and more, fits nearly as well).
/// @throws InputError fewer than 10 points, not finite, options out of range.
Cancellable<RigidStart> align_rigid(const PatientModel& model, const LabelledCloud& cloud,
                                    const RigidOptions& options, const RunContext& context);
/// The same from about a pose that a person has set: starts are drawn around it (15 degrees and 10 mm about
/// each axis, one deviation). That pose itself is one more alternative, should the cloud draw the model
/// elsewhere.
Cancellable<RigidStart> align_rigid_near(const PatientModel& model, const LabelledCloud& cloud,
                                         const CameraFromCt& near, const RigidOptions& options,
                                         const RunContext& context);

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
  /// pose and shape are fitted first (fit_shape), and the elastic stages start from that shape as one that is
  /// free of stress: the loads that made it go on holding it.
  std::shared_ptr<const OperationPrior> prior;
  ShapeFitOptions shape;
  /// @throws InputError naming the option.
  void validate() const;
};

/// The defaults for a model. One that is a bare mesh (no vessels, and no landmarks that a person placed; a
/// margin that was detected on a mesh says nothing of its material) is taken for homogeneous: no capsule, and
/// the paper's schedule without the final stiffening, its springs isotropic.
ElasticOptions options_for(const PatientModel& model, bool landmarks_are_placed = true);

/// Initial elastic registration (paper 2.2.3; eq. 14 and 15 as the README corrects them): label-restricted
/// closest points, implicit Euler steps, plateaus of kinetic energy and mean residual, stop at max(r) + 1.
/// Registration::residual is the mean over the pairs kept (outliers excluded).
/// Doubts: few_margin_points, no_notch, little_surface_seen (under a fifth of the model's), many_outliers,
/// residual_large, inverted_elements, pull_not_at_rest (the most steps were done), mechanics_failed; with a
/// prior shape_ambiguous (another shape, 10 mm away on average and more, is nearly as probable) and
/// shape_unusual (an amplitude beyond four standard deviations).
/// @pre no options.prior. @throws InputError fewer than 10 points, not finite, hardly any of which meet the
/// model from `start`; unusable options or mesh; fixed nodes out of range.
Cancellable<Registration> register_elastic(const PatientModel& model, const LabelledCloud& cloud,
                                           const CameraFromCt& start, const ElasticOptions& options,
                                           const RunContext& context);

/// A model whose rest shape is `nodes`: its tetrahedra, and the vessels bound to them. It stands for an organ
/// that is held there by the loads that brought it there. Constant nodal forces could hold it as well, but
/// would not turn with it and would tip it over. @param nodes N x 3, metres, any one frame.
PatientModel moved_to(const PatientModel& model, const Points& nodes);

/// Eq. 15. @param n plateau index. @pre r > 0, n >= 0.
double stiffness_at_plateau(double k_min, double k_max, int r, int n);
/// Eq. 14's force over k at distance d, metres, positive towards the cloud. @pre s > 0, d >= 0.
double penalty_force(PenaltyForm form, double s, double d);

}  // namespace glisson::registration
