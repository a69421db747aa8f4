// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/register.h"

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"

namespace glisson::engine {
namespace {

/// Operations that an earlier registration has simulated on the same model.
registration::KnownOperations known_operations(const CaseState& state) {
  const auto& known = state[part::operations];
  if (!known || known->model != state[part::model] || known->landmarks != state[part::landmarks]) return {};
  return {known->options, known->prior};
}

void add_figures(Figures& figures, const registration::Registered& made) {
  const Registration& registration = made.registration;
  if (made.rigid_residual) figures["rigid_residual_mm"] = 1e3 * *made.rigid_residual;
  if (made.operations) {
    figures["operations_simulated"] = made.operations->operations;
    figures["operations_motion_mean_mm"] = 1e3 * made.operations->mean_motion;
  }
  figures["displacement_mean_mm"] = 1e3 * made.displacement.mean;
  figures["displacement_max_mm"] = 1e3 * made.displacement.maximum;
  figures["registration_residual_mm"] = 1e3 * registration.residual;
  figures["registration_seen_share"] = registration.seen_share;
  figures["registration_steps"] = registration.steps;
  figures["registration_plateaus"] = registration.plateaus;
  figures["registration_converged"] = registration.termination == Termination::converged ? 1.0 : 0.0;
}

}  // namespace

CommandTraits Register::traits() const {
  return {.code = "register",
          .reads = {part::model, part::landmarks, part::cloud},
          .writes = {part::registration},
          .needs = {part::model, part::cloud},
          .current = {part::model, part::landmarks, part::cloud}};
}

Cancellable<Applied> Register::apply(const CaseState& state, const RunContext& context) const {
  const registration::KnownOperations known = known_operations(state);
  auto made =
      registration::register_model(effective_model(state), *state[part::cloud], *this, context, known);
  if (!made) return {};
  Applied applied{state};
  add_figures(applied.figures, *made);
  applied.notes = made->registration.doubts;
  if (made->operations && made->operations != known.prior)
    applied.state[part::operations] = std::make_shared<const SimulatedOperations>(SimulatedOperations{
        state[part::model], state[part::landmarks], operation, std::move(made->operations)});
  applied.state[part::registration] = std::make_shared<const Registration>(std::move(made->registration));
  return applied;
}

}  // namespace glisson::engine
