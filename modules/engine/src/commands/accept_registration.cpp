// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/accept_registration.h"

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/refusal.h"
#include "registration_figures.h"
#include "seen.h"

namespace glisson::engine {

CommandTraits AcceptRegistration::traits() const {
  return {.code = "accept_registration",
          .reads = {part::model, part::landmarks, part::cloud, part::registration},
          .writes = {part::registration},
          .needs = {part::registration},
          .current = {part::registration},
          .lane = Lane::edits};
}

Cancellable<Applied> AcceptRegistration::apply(const CaseState& state, const RunContext&) const {
  require_seen(state, part::registration, seen);
  Applied applied{state};
  Registration accepted = *state[part::registration];
  registration::accept_refusal(accepted);
  applied.notes = told_of(accepted);
  applied.figures = figures_of(accepted);
  applied.state[part::registration] = std::make_shared<const Registration>(std::move(accepted));
  return applied;
}

}  // namespace glisson::engine
