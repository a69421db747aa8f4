// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/simulate_operations.h"

#include <utility>

#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/operations.h"
#include "glisson/engine/parts/tissue.h"

namespace glisson::engine {

CommandTraits SimulateOperations::traits() const {
  return {.code = "simulate_operations",
          .reads = {part::model, part::landmarks, part::tissue, part::operations},
          .writes = {part::operations},
          .needs = {part::model},
          .current = {part::model, part::landmarks},
          .notice = Notice::unasked};
}

Cancellable<Applied> SimulateOperations::apply(const CaseState& state, const RunContext& context) const {
  Applied applied{state};
  std::shared_ptr<const registration::OperationPrior> prior;
  const registration::KnownOperations known = known_operations(state, context.seed());
  const registration::OperationOptions options = with_tissue_of(state, *this);
  if (known.prior && known.options == options) {
    prior = known.prior;
  } else {
    auto made = registration::simulate_operations(effective_model(state), options, context);
    if (!made) return {};
    prior = std::make_shared<const registration::OperationPrior>(std::move(*made));
    applied.state[part::operations] = std::make_shared<const SimulatedOperations>(
        SimulatedOperations{state[part::model], state[part::landmarks], options, context.seed(), prior});
  }
  applied.figures["operations_simulated"] = prior->operations;
  applied.figures["operations_motion_mean_mm"] = 1e3 * prior->mean_motion;
  return applied;
}

bool lacks_operations(const CaseState& state) {
  return !obstacle(state, SimulateOperations{}) && !has_operations(state) &&
         registration::can_simulate_operations(effective_model(state));
}

}  // namespace glisson::engine
