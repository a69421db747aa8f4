// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/choose_rival.h"

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/rivals.h"

namespace glisson::engine {

CommandTraits ChooseRival::traits() const {
  return {.code = "choose_rival",
          .reads = {part::model, part::landmarks, part::cloud, part::registration},
          .writes = {part::registration},
          .needs = {part::registration, part::cloud},
          .current = {part::registration},
          .lane = Lane::edits};
}

Cancellable<Applied> ChooseRival::apply(const CaseState& state, const RunContext&) const {
  Applied applied{state};
  Registration chosen = registration::choose_rival(*state[part::registration], rival,
                                                   state[part::model]->model, *state[part::cloud]);
  applied.notes = chosen.doubts;
  applied.state[part::registration] = std::make_shared<const Registration>(std::move(chosen));
  return applied;
}

}  // namespace glisson::engine
