// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>

#include "glisson/core/run_context.h"
#include "glisson/fem/composite_model.h"
#include "glisson/fem/elastic_body.h"
#include "glisson/patient/patient_model.h"

/// @file
/// What operations do to this patient's liver, known before the camera sees it. Elasticity alone says which
/// deformation is cheapest for what is seen; but what is not seen is not left alone, it is bent by loads that
/// are much alike from one operation to the next. So operations are simulated on the patient's own model, and
/// their principal components say how the unseen part goes along with the seen one (statistical motion models
/// from biomechanical simulation: Mohamed, Davatzikos and Taylor 2002; Hu et al. 2012, for the prostate).

namespace glisson::registration {

/// Forces that nobody has simulated (tools, contacts, ligaments cut), anywhere on the surface: the motion of
/// a node that they cause, rms, and how far one spreads, m.
inline constexpr double kUnforeseenMotion = 4e-3, kUnforeseenSpread = 35e-3;

/// Which operations are simulated: how many, with what loads, on what tissue.
struct OperationOptions {
  int operations = 160;  ///< simulated
  int modes = 60;        ///< principal components kept, at most
  /// Standard deviations of the loads, each drawn from a normal distribution about none.
  double gravity = 2.8;   ///< m/s2 along each axis: the table is tilted, the CT was made supine
  double gas_pa = 350.0;  ///< on the anterior and diaphragmatic face, and again its slope from left to right
  double bed_m = 0.014;   ///< by which the organs behind give way at 9 cm from the vena cava
  double ligament_m = 0.007;    ///< by which the abdominal wall takes the falciform ligament along
  double contact_spread = 0.5;  ///< of the logarithm of the stiffness of bed, diaphragm and ligament
  double unforeseen_m = kUnforeseenMotion;  ///< 0: there are none
  /// Pa, of the parenchyma
  double young_modulus = fem::CompositeOptions().parenchyma.young_modulus;
  double poisson_ratio = fem::CompositeOptions().parenchyma.poisson_ratio;
  std::map<Label, double> lesions;  ///< Young's modulus of each, Pa; missing ones are parenchyma
  int threads = 2;                  ///< 1 or 2: the same bits
  /// @throws InputError naming the option.
  void validate() const;
  /// Whether the same operations come of both: of the threads they know nothing.
  bool operator==(const OperationOptions& other) const;
};

/// The deformations of one patient's liver over simulated operations, as principal components, and by what
/// nobody has simulated.
struct OperationPrior {
  /// 3 N x K: displacement of each node (x, y, z of the first, then of the second, ...) by one standard
  /// deviation of each component, metres, in the CT's frame, free of rigid motion: first the operations', the
  /// largest first, then the unforeseen forces'. Their covariances add up.
  fem::NodalColumns modes;
  int operations = 0;        ///< of which an equilibrium was found
  double mean_motion = 0.0;  ///< of a node, over all nodes and simulated operations, metres

  /// The rest shape moved by amplitudes in standard deviations. @pre as many as there are modes.
  Points shape(const Points& rest, const Eigen::VectorXd& amplitudes) const;
};

/// Where operations cannot be simulated: unforeseen forces alone, which move a node by 8 mm (rms).
/// @param options of which moduli and Poisson's ratio are taken.
/// Cancelled: without modes.
OperationPrior unknown_operations(const PatientModel& model, const OperationOptions& options = {},
                                  const RunContext& context = {});

/// Whether the model holds what operations are simulated with: its vena cava must be known.
bool can_simulate_operations(const PatientModel& model);

/// Simulates operations: the organ, its parenchyma and lesions, co-rotational (vessels and capsule would cost
/// ten times as much and change a distribution of loads by little), is held at the vena cava, rests on the
/// bed behind and under the diaphragm, is tied to the wall by the falciform ligament where the notch is
/// known; gravity turns, gas presses, the bed gives way as a polynomial of second order, the wall lifts. The
/// same seed gives the same bits. Seconds for 2,000 tetrahedra.
/// @throws InputError options, no vena cava; NumericalError when fewer than 30 operations have an
/// equilibrium.
Cancellable<OperationPrior> simulate_operations(const PatientModel& model, const OperationOptions& options,
                                                const RunContext& context);

}  // namespace glisson::registration
