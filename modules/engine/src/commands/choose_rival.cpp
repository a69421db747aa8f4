// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/choose_rival.h"

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/rivals.h"
#include "registration_figures.h"
#include "seen.h"

namespace glisson::engine {

CommandTraits ChooseRival::traits() const {
  return {.code = "choose_rival",
          .reads = inputs_of_former_registration(),
          .writes = {part::registration, part::former_registration},
          .needs = {part::registration, part::cloud},
          .current = {part::registration},
          .lane = Lane::edits};
}

Cancellable<Applied> ChooseRival::apply(const CaseState& state, const RunContext&) const {
  require_seen(state, part::registration, seen);
  Registration chosen =
      registration::choose_rival(*state[part::registration], rival, state[part::model]->model,
                                 *state[part::cloud], !looks_to_join(state).empty());
  Applied applied{state, figures_of(chosen), told_of(chosen)};
  keep_former_registration(applied.state, state);
  applied.state[part::registration] = std::make_shared<const Registration>(std::move(chosen));
  return applied;
}

}  // namespace glisson::engine
