// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/register.h"

#include <cstdint>
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
#include "glisson/engine/register_options.h"
#include "glisson/registration/examined_registration.h"
#include "registration_figures.h"

namespace glisson::engine {
namespace {

Cancellable<registration::ExaminedRegistration> made_with_notes(const CaseState& state,
                                                                const PatientModel& model,
                                                                const registration::RegisterOptions& options,
                                                                const registration::KnownOperations& known,
                                                                const RunContext& context) {
  auto examined = registration::register_model(model, *state[part::cloud], options, context, known);
  if (examined) examined->registered.registration.notes = notes_of(state, model, options, *examined);
  return examined;
}

/// @param operation the options of the operations that were simulated for it, where these are not `known`.
Applied with_registered(const CaseState& state, registration::ExaminedRegistration examined,
                        const registration::KnownOperations& known,
                        const registration::OperationOptions& operation, std::uint64_t seed) {
  registration::Registered& made = examined.registered;
  Applied applied{state, figures_of(examined), told_of(made.registration)};
  if (made.operations && made.operations != known.prior)
    keep_operations(applied.state, operation, seed, std::move(made.operations));
  keep_former_registration(applied.state, state);
  applied.state[part::registration] = std::make_shared<const Registration>(std::move(made.registration));
  return applied;
}

}  // namespace

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
  const registration::RegisterOptions options = options_with_looks(state, *this);
  const PatientModel model = effective_model(state);
  auto examined = made_with_notes(state, model, options, known, context);
  if (!examined) return {};
  return with_registered(state, std::move(*examined), known, registration::operation_of(options, model),
                         context.seed());
}

}  // namespace glisson::engine
