// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/take_registration.h"

#include <utility>

#include "changed_live.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/other_registration.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/refusal.h"
#include "registration_figures.h"
#include "seen.h"

namespace glisson::engine {
namespace {

/// @throws InputError it was refused.
const OtherRegistration& other_of(const CaseState& state) {
  const OtherRegistration& other = *state[part::other_registration];
  if (registration::is_refused(other.registration))
    throw InputError("registration", "the other one", "was refused: what is known contradicts it",
                     "Register again, from more of the surface");
  return other;
}

/// The other one takes the place of the case's, and that one its place.
void exchange(CaseState& made, const CaseState& before, const OtherRegistration& other) {
  keep_former_registration(made, before);
  made[part::registration] = std::make_shared<const Registration>(other.registration);
  auto former = std::make_shared<OtherRegistration>(other);
  former->registration = *before[part::registration];
  former->is_former = !other.is_former;
  made[part::other_registration] = std::move(former);
}

}  // namespace

std::optional<TakeRegistration> take_if_better(const CaseState& state) {
  const auto& other = state[part::other_registration];
  if (!other || !other->is_better || other->is_former) return std::nullopt;
  return TakeRegistration{other};
}

CommandTraits TakeRegistration::traits() const {
  const Parts parts = {part::registration, part::other_registration, part::live};
  return {.code = "take_registration",
          .reads = parts | inputs_of_former_registration(),
          .writes = parts | Parts{part::former_registration},
          .needs = {part::live, part::other_registration},
          .current = {part::live, part::other_registration},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> TakeRegistration::apply(const CaseState& state, const RunContext&,
                                             const Services& services) const {
  require_seen(state, part::other_registration, seen);
  Follower& follower = follower_of(services);
  const OtherRegistration& other = other_of(state);
  Applied applied = with_live(state, follower.take(other.registration), follower);
  exchange(applied.state, state, other);
  applied.notes = told_of(other.registration);
  return applied;
}

}  // namespace glisson::engine
