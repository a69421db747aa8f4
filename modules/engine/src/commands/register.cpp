// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/register.h"

#include <string>
#include <utility>

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/operations.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/next_look.h"
#include "registration_figures.h"

namespace glisson::engine {
CommandTraits Register::traits() const {
  return {.code = "register",
          .reads = {part::model, part::landmarks, part::tissue, part::operations, part::proposals,
                    part::cloud, part::earlier_looks},
          .writes = {part::operations, part::registration, part::former_registration},
          .needs = {part::model, part::cloud},
          .current = {part::model, part::landmarks, part::cloud}};
}

Cancellable<Applied> Register::apply(const CaseState& state, const RunContext& context) const {
  const registration::KnownOperations known = known_operations(state, context.seed());
  registration::RegisterOptions options = *this;
  options.landmarks_are_placed = state[part::landmarks] != nullptr;
  if (options.tissue.empty()) options.tissue = tissue_of(state, !options.materials);
  for (const auto& look : looks_to_join(state)) options.looks.push_back(*look);
  const PatientModel model = effective_model(state);
  auto examined = registration::register_and_examine(model, *state[part::cloud], options, context, known);
  if (!examined) return {};
  registration::Registered* made = &examined->registered;
  Applied applied{state, figures_of(*examined)};
  applied.notes = made->registration.doubts;
  for (const Label gone : fem::lesions_not_there(options.tissue, model))
    applied.notes.push_back("tissue.no_lesion " + structure_name(gone));
  for (std::string& note : landmark_notes(state)) applied.notes.push_back(std::move(note));
  for (std::string& note : registration::look_notes(model, made->registration))
    applied.notes.push_back(std::move(note));
  if (made->operations && made->operations != known.prior)
    applied.state[part::operations] = std::make_shared<const SimulatedOperations>(SimulatedOperations{
        state[part::model], state[part::landmarks], registration::operation_of(options, model),
        context.seed(), std::move(made->operations)});
  keep_former_registration(applied.state, state);
  applied.state[part::registration] = std::make_shared<const Registration>(std::move(made->registration));
  return applied;
}

}  // namespace glisson::engine
