// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/undo_registration.h"

#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/registration.h"
#include "registration_figures.h"

namespace glisson::engine {

CommandTraits UndoRegistration::traits() const {
  return {.code = "undo_registration",
          .reads = inputs_of_former_registration() | Parts{part::former_registration},
          .writes = {part::registration, part::former_registration},
          .needs = {part::former_registration},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> UndoRegistration::apply(const CaseState& state, const RunContext&) const {
  if (!has_former_registration(state))
    throw InputError("registration", "the former one",
                     "is of another model, other landmarks, stiffness or points", "Register again");
  Applied applied{state};
  keep_former_registration(applied.state, state);
  applied.state[part::registration] = state[part::former_registration]->registration;
  applied.notes = told_of(*applied.state[part::registration]);
  return applied;
}

}  // namespace glisson::engine
