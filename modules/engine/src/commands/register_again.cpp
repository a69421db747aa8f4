// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/register_again.h"

#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/operations.h"
#include "glisson/engine/parts/other_registration.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/engine/register_options.h"
#include "glisson/registration/register_again.h"
#include "registration_figures.h"

namespace glisson::engine {
namespace {

/// None where the case's is of another moment than the one that is followed (its pair or calibration is
/// another one by now): it lies in another frame than the tissue.
LabelledCloud cloud_of(const CaseState& state) {
  return stage_state(state, part::cloud) == StageState::current ? *state[part::cloud] : LabelledCloud();
}

/// @throws InputError the tissue has not been seen yet.
Cancellable<registration::RegisteredAgain> registered(const CaseState& state,
                                                      const registration::RegisterOptions& options,
                                                      const RunContext& context) {
  const auto& seen = state[part::live]->tissue_at_start;
  if (!seen)
    throw InputError("registration", "tissue", "has not been seen often enough yet",
                     "Follow the organ in a stereo video for a second");
  const PatientModel model = effective_model(state);
  const registration::RegisterOptions made_by = options_of(state, options);
  auto again = registration::register_again(model, cloud_of(state), *seen, *state[part::registration],
                                            made_by, context, known_operations(state, context.seed()));
  if (again) again->examined.registered.registration.notes = notes_of(state, model, made_by, again->examined);
  return again;
}

Figures figures_of(const registration::RegisteredAgain& again) {
  Figures figures = engine::figures_of(again.examined);
  figures["again_better"] = again.is_better ? 1.0 : 0.0;
  figures["again_kept_out"] = again.kept_out;
  figures["again_former_gap_mm"] = 1e3 * again.former_gap;
  figures["again_gap_mm"] = 1e3 * again.gap;
  figures["again_moved_mm"] = 1e3 * again.moved;
  return figures;
}

OtherRegistration other_of(registration::RegisteredAgain again) {
  return {std::move(again.examined.registered.registration),
          false,
          again.is_better,
          again.former_gap,
          again.gap,
          again.moved};
}

}  // namespace

CommandTraits RegisterAgain::traits() const {
  return {.code = "register_again",
          .reads = {part::model, part::landmarks, part::tissue, part::operations, part::proposals,
                    part::cloud, part::registration, part::live},
          .writes = {part::other_registration},
          .needs = {part::registration, part::model, part::live},
          .current = {part::model, part::landmarks, part::registration}};
}

Cancellable<Applied> RegisterAgain::apply(const CaseState& state, const RunContext& context) const {
  auto again = registered(state, *this, context);
  if (!again) return {};
  Applied applied{state, figures_of(*again), told_of(again->examined.registered.registration)};
  applied.state[part::other_registration] =
      std::make_shared<const OtherRegistration>(other_of(std::move(*again)));
  return applied;
}

}  // namespace glisson::engine
