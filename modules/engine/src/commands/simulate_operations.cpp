// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/simulate_operations.h"

#include <utility>

#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/operations.h"
#include "glisson/engine/parts/tissue.h"

namespace glisson::engine {
namespace {

Figures figures_of(const registration::OperationPrior& prior) {
  return {{"operations_simulated", prior.operations}, {"operations_motion_mean_mm", 1e3 * prior.mean_motion}};
}

/// @return false: cancelled.
bool simulate_into(CaseState& state, const registration::OperationOptions& options,
                   const RunContext& context) {
  auto made = registration::simulate_operations(effective_model(state), options, context);
  if (!made) return false;
  keep_operations(state, options, context.seed(),
                  std::make_shared<const registration::OperationPrior>(std::move(*made)));
  return true;
}

}  // namespace

CommandTraits SimulateOperations::traits() const {
  return {.code = "simulate_operations",
          .reads = {part::model, part::landmarks, part::tissue, part::operations},
          .writes = {part::operations},
          .needs = {part::model},
          .current = {part::model, part::landmarks},
          .notice = Notice::unasked};
}

Cancellable<Applied> SimulateOperations::apply(const CaseState& state, const RunContext& context) const {
  const registration::KnownOperations known = known_operations(state, context.seed());
  const registration::OperationOptions options = with_tissue_of(state, *this);
  Applied applied{state};
  const bool are_known = known.prior && known.options == options;
  if (!are_known && !simulate_into(applied.state, options, context)) return {};
  applied.figures = figures_of(*applied.state[part::operations]->prior);
  return applied;
}

bool lacks_operations(const CaseState& state) {
  return !obstacle(state, SimulateOperations{}) && !has_operations(state) &&
         registration::can_simulate_operations(effective_model(state));
}

}  // namespace glisson::engine
