// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/experiments/paper_figure.h"
#include "glisson/patient/patient_model.h"

/// @file
/// The paper's Fig. 6: how much a deformed liver's shape depends on where its boundary conditions are and how
/// stiff they are. The model lay supine in the CT; gravity turns to the flank. Reference supports: the
/// falciform ligament at the umbilical notch, and the vena cava. The composite liver has vessels and capsule.

namespace glisson::experiments {

/// Of both supports, k = E A / L, N/m: E = 20 MPa (paper, 3.1), the section A and length L of
/// resources/loads/supine_to_left_flank.json.
inline constexpr double kCavaStiffness = 20e6 * 60e-6 / 0.04, kLigamentStiffness = 20e6 * 20e-6 / 0.04;

/// What is altered.
enum class Support { notch, cava, both };
inline constexpr std::array<Support, 3> kSupports = {Support::notch, Support::cava, Support::both};
/// "notch", "cava", "both".
const char* support_code(Support support);

/// Which posture is simulated, and how its supports are altered: moved along the surface, or made softer and
/// stiffer.
struct SensitivityOptions {
  enum class Flank { left, right };  ///< the side that is down
  Flank flank = Flank::left;
  /// Metres along the surface, ascending.
  std::vector<double> shifts = {0.0, 1e-3, 2e-3, 3e-3, 5e-3, 7.5e-3, 10e-3, 12.5e-3, 15e-3, 17.5e-3};
  int directions = 6;                                        ///< evenly around, in the surface
  std::vector<double> factors = {0.1, 0.5, 1.0, 2.0, 10.0};  ///< of the stiffness
  /// Few trials: to see whether it runs.
  static SensitivityOptions quick();
  /// @throws InputError naming the option.
  void validate() const;
};

/// How far a final shape is from the reference's, metres.
struct ShapeDistance {
  /// The paper's "mean Hausdorff distance", as it is computed here: from each vertex of one surface to the
  /// closest point of the other, mean over vertices; half the sum of both directions. It does not see
  /// sliding.
  double surface = 0.0;
  double nodes = 0.0;  ///< mean over all nodes of how far the same node is
};
/// Of two positions (N x 3, one frame) of the same model's nodes.
ShapeDistance shape_distance(const PatientModel& model, const PointsIn<CtFrame>& a,
                             const PointsIn<CtFrame>& b);

/// A support moved by one distance, in several directions.
struct ShiftRow {
  Support support = Support::both;
  double shift = 0.0;              ///< metres
  ShapeDistance mean;              ///< over the directions whose equilibrium was found
  double least = 0.0, most = 0.0;  ///< of the surface's, over the same, metres
  int solved = 0, tried = 0;
};
/// A support whose stiffness was multiplied.
struct StiffnessRow {
  Support support = Support::both;
  double factor = 1.0;
  ShapeDistance distance;  ///< not a number: no equilibrium was found
};
/// How far the final shape moves when its supports are altered, against the unaltered reference.
struct Sensitivity {
  double motion_mean = 0.0, motion_max = 0.0;  ///< of the reference's nodes, from supine to flank, metres
  std::vector<ShiftRow> shifts;                ///< by support, then by shift
  std::vector<StiffnessRow> stiffness;         ///< by support, then by factor
  /// Slope of log distance over log shift, one a support: 1 is linear, 2 quadratic. Not a number: too few.
  std::array<double, kSupports.size()> exponents{};
};

/// @param model with landmarks: umbilical notch and vena cava. Empty: cancelled.
/// @throws InputError options; the model lacks a landmark. NumericalError the reference has no equilibrium.
Cancellable<Sensitivity> boundary_sensitivity(const PatientModel& model, const SensitivityOptions& options,
                                              const RunContext& context);

/// The figure's tables and figures, without its command.
PaperFigure figure_of(const Sensitivity& found);

}  // namespace glisson::experiments
