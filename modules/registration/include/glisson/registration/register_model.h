// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "glisson/core/run_context.h"
#include "glisson/geometry/distance.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/contact_forces.h"
#include "glisson/registration/operation_prior.h"
#include "glisson/registration/register.h"

namespace glisson::registration {

/// How the shape is found once there is a start.
enum class Method {
  /// Forces: together with the operations' modes where those are known, and for a bare mesh (no vessels, no
  /// vena cava) of which nodes are fixed. Else springs.
  automatic,
  forces,  ///< fit_contact_forces
  springs  ///< register_elastic: the paper's, with operations before it where they are asked for
};

/// @return whether the shape is found by contact forces where no operations are known.
bool takes_forces(Method method, const PatientModel& model, const ElasticOptions& elastic);
/// `forces` with the fixed nodes and the lesions' stiffness that hold for the springs.
ContactForceOptions forces_with(const PatientModel& model, const ElasticOptions& elastic,
                                ContactForceOptions forces = {});

/// Rigid start, then elastic.
struct RegisterOptions {
  Method method = Method::automatic;
  enum class Start {
    automatic,  ///< align_rigid
    none,       ///< the model is in the camera's frame already
    near,       ///< align_rigid_near: from where a hand has put the model, say
    given       ///< as it is
  };
  Start start = Start::automatic;
  CameraFromCt given;  ///< for Start::near and Start::given
  RigidOptions rigid;  ///< for Start::automatic and Start::near
  ElasticOptions
      elastic;  ///< of the springs; its fixed nodes and the lesions' stiffness hold for the forces, too
  ContactForceOptions forces;
  /// Where no node is fixed: operations are simulated first and tell which shapes are probable
  /// (simulate_operations; unknown_operations where the vena cava is not known and the pose is not either);
  /// false: the paper's method. A prior in `elastic` is taken instead.
  bool operations = true;
  OperationOptions operation;
  /// What is used of them. @throws InputError naming the option.
  void validate() const;
};

/// Operations that are simulated already.
struct KnownOperations {
  OperationOptions options;                     ///< that they were simulated with
  std::shared_ptr<const OperationPrior> prior;  ///< of the same model; null: none
};

/// A model registered from the start.
struct Registered {
  Registration registration;              ///< with the rigid start's doubts before its own
  std::optional<ContactForceFit> forces;  ///< where these were the method
  std::optional<double> rigid_residual;   ///< metres; empty: the start was not sought
  /// Those that the registration rests on, known or new; null: none were needed or possible.
  std::shared_ptr<const OperationPrior> operations;
  DistanceSummary displacement;  ///< of the nodes, from where the rigid part alone puts them, metres
};

/// Brings a model to what the camera sees: rigid start, the shapes that operations make probable, the most
/// probable of them from each start that fits, elastic. Where operations cannot be simulated on the model,
/// elasticity alone decides. The same seed gives the same bits. Doubts of the forces: little_surface_seen,
/// many_outliers, residual_large, inverted_elements (not under the linear law, which knows of none),
/// law_ambiguous (another law puts the nodes 5 mm away on average and is nearly as probable),
/// forces_not_at_rest, with operations forces_many (how many tools act, the limit).
/// @param known taken where its options are those of `options`; operations are not simulated again.
/// @throws InputError as align_rigid, simulate_operations, register_elastic; NumericalError as
///   simulate_operations.
Cancellable<Registered> register_model(const PatientModel& model, const LabelledCloud& cloud,
                                       const RegisterOptions& options, const RunContext& context,
                                       const KnownOperations& known = {});

}  // namespace glisson::registration
