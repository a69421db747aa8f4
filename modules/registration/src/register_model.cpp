// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/register_model.h"

#include <utility>
#include <vector>

namespace glisson::registration {
namespace {

using Start = RegisterOptions::Start;

Cancellable<RigidStart> start_of(const PatientModel& model, const LabelledCloud& cloud,
                                 const RegisterOptions& options, const RunContext& context) {
  if (options.start == Start::automatic) return align_rigid(model, cloud, options.rigid, context);
  RigidStart start;
  if (options.start == Start::given) start.camera_from_ct = options.given;
  return start;
}

bool needs_operations(const PatientModel& model, const RegisterOptions& options) {
  return options.operations && !options.elastic.prior && options.elastic.fixed_nodes.empty() &&
         can_simulate_operations(model);
}

Cancellable<std::shared_ptr<const OperationPrior>> operations_of(const PatientModel& model,
                                                                 const OperationOptions& options,
                                                                 const KnownOperations& known,
                                                                 const RunContext& context) {
  if (known.prior && known.options == options) return known.prior;
  auto prior = simulate_operations(model, options, context);
  if (!prior) return {};
  return std::make_shared<const OperationPrior>(std::move(*prior));
}

}  // namespace

void RegisterOptions::validate() const {
  if (start == Start::automatic) rigid.validate();
  if (operations) operation.validate();
  elastic.validate();
}

Cancellable<Registered> register_model(const PatientModel& model, const LabelledCloud& cloud,
                                       const RegisterOptions& options, const RunContext& context,
                                       const KnownOperations& known) {
  options.validate();
  const bool is_automatic = options.start == Start::automatic;
  Registered result;
  double done = 0.0;  ///< share of the work
  auto start = start_of(model, cloud, options, context.part(0.0, 0.2));
  if (!start) return {};
  if (is_automatic) done = 0.2, result.rigid_residual = start->residual;
  ElasticOptions elastic = options.elastic;
  if (needs_operations(model, options)) {
    auto prior = operations_of(model, options.operation, known, context.part(done, 0.7));
    if (!prior) return {};
    done = 0.7;
    result.operations = elastic.prior = *prior;
    elastic.other_starts = std::move(start->alternatives);
  }
  auto registered = register_elastic(model, cloud, start->camera_from_ct, elastic, context.part(done, 1.0));
  if (!registered) return {};
  registered->doubts.insert(registered->doubts.begin(), start->doubts.begin(), start->doubts.end());
  result.displacement =
      point_errors(registered->nodes_in_camera, registered->camera_from_ct.apply(model.mesh.vertices));
  result.registration = std::move(*registered);
  return result;
}

}  // namespace glisson::registration
