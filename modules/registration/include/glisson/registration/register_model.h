// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/codes.h"
#include "glisson/core/run_context.h"
#include "glisson/fem/tissue.h"
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
  forces,   ///< contact forces (contact_forces.h)
  springs,  ///< of eq. 14 and 15 (elastic.h), with operations before them where they are asked for
  paper     ///< the paper's: springs, and elasticity alone (no operations)
};
/// For the command line.
inline constexpr Codes<Method, 4> kMethodCodes = {{{"automatic", Method::automatic},
                                                   {"forces", Method::forces},
                                                   {"springs", Method::springs},
                                                   {"paper", Method::paper}}};

/// @return whether the shape is found by contact forces where no operations are known.
bool takes_forces(Method method, const PatientModel& model, const ElasticOptions& elastic);
/// `forces` with the fixed nodes and the lesions' stiffness that hold for the springs.
ContactForceOptions forces_with(const PatientModel& model, const ElasticOptions& elastic,
                                ContactForceOptions forces = {});

/// Rigid start, then elastic. What is left empty the model decides: window, command line and proofs say
/// nothing of it, and so register one model under one law.
struct RegisterOptions {
  Method method = Method::automatic;
  enum class Start {
    automatic,  ///< sought from everywhere (rigid.h)
    /// The model is in the cloud's frame already. Nobody says that a camera stood in its origin: what can be
    /// judged only by where it stood is not.
    none,
    near,  ///< sought from about a pose: from where a hand has put the model, say
    given  ///< as it is
  };
  Start start = Start::automatic;
  CameraFromCt given;  ///< for Start::near and Start::given
  RigidOptions rigid;  ///< for Start::automatic and Start::near, and for the looks
  /// Other looks at the same organ, which has not moved since (looks.h): clouds, each in its own left
  /// camera's frame; where they were seen from is found. The result is in the frame of the cloud that they
  /// join.
  std::vector<LabelledCloud> looks;
  /// What the liver is made of, for springs and forces. Empty: as options_for() takes this model.
  std::optional<fem::CompositeOptions> materials;
  /// What is said of this patient's parenchyma and lesions, over `materials`; holds for operations,
  /// unforeseen forces and the error model, too.
  fem::Tissue tissue;
  std::vector<int> fixed_nodes;  ///< stay where the start puts them, in springs and forces
  /// A person has placed or accepted the model's landmarks; false: they were only detected, which says
  /// nothing of the material of a bare mesh.
  bool landmarks_are_placed = true;
  /// What is doubted of the model itself, as codes: each registration of it has these doubts, too.
  std::vector<std::string> model_doubts;
  /// Of the springs. Empty: options_for() this model.
  std::optional<ElasticOptions> elastic;
  ContactForceOptions forces;
  /// Where no node is fixed: operations are simulated first and tell which shapes are probable
  /// (simulate_operations; unknown_operations where the vena cava is not known and the pose is not either);
  /// false: elasticity alone. A prior in `elastic` is taken instead.
  bool operations = true;
  OperationOptions operation;
  /// Of every step, 1 or 2, over those of the steps' own options: the same bits.
  int threads = 2;
  /// What is used of them. @throws InputError naming the option.
  void validate() const;
};

/// What the springs work with on a model: `options.elastic` or what the model decides, with the materials and
/// fixed nodes of `options` in it.
ElasticOptions elastic_of(const RegisterOptions& options, const PatientModel& model);

/// What operations are simulated with: `options.operation`, and where something is said of materials or
/// tissue the moduli of these.
OperationOptions operation_of(const RegisterOptions& options, const PatientModel& model);

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
  std::vector<double> look_distances;  ///< of each look from the result, metres (distances_of_looks)
  DistanceSummary displacement;        ///< of the nodes, from where the rigid part alone puts them, metres
};

struct ExaminedRegistration;  // examined_registration.h

/// The one door by which a model is registered: brings it to what the camera sees and asks how wrong that is.
/// Rigid start, the shapes that operations make probable, the most probable of them from each start that
/// fits, elastic. Where operations cannot be simulated on the model, elasticity alone decides. Where a prior
/// is known and the start is sought, the cloud's mirror image is registered, too. What is no point of the
/// cloud is left out (sound_cloud(); zeros unless the cloud is in the model's frame). The same seed gives the
/// same bits.
///
/// Doubts of the rigid start and of the springs stand in rigid.h and elastic.h. Of the forces:
/// little_surface_seen, many_outliers, residual_large; inverted_elements, with operations those of the shape
/// itself, without them any (but under the linear law, which knows of none, only where no tissue is so,
/// is_beyond_tissue()); law_ambiguous (another law puts the nodes 5 mm away on average and is nearly as
/// probable); forces_not_at_rest; with operations forces_many (how many tools act, the limit).
/// @param known taken where its options are those of `options`; operations are not simulated again.
/// @throws InputError as simulate_operations; options; an unusable mesh; fixed nodes out of range; fewer than
///   10 points of the surface, not finite, hardly any of which meet the model from a start that is given.
///   NumericalError as simulate_operations.
Cancellable<ExaminedRegistration> register_model(const PatientModel& model, const LabelledCloud& cloud,
                                                 const RegisterOptions& options, const RunContext& context,
                                                 const KnownOperations& known = {});

}  // namespace glisson::registration
