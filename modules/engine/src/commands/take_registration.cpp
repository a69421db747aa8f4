// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/take_registration.h"

#include <utility>

#include "changed_live.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/other_registration.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/refusal.h"
#include "seen.h"

namespace glisson::engine {
namespace {

/// @throws InputError it was refused.
OtherRegistration other_of(const CaseState& state) {
  const OtherRegistration& other = *state[part::other_registration];
  if (registration::is_refused(other.registration))
    throw InputError("registration", "the other one", "was refused: what is known contradicts it",
                     "Register again, from more of the surface");
  return other;
}

}  // namespace

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
  OtherRegistration former = other_of(state);
  auto taken = std::make_shared<const Registration>(std::move(former.registration));
  Applied applied = with_live(state, follower.take(*taken), follower);
  keep_former_registration(applied.state, state);
  former.registration = *state[part::registration];
  former.is_former = !former.is_former;
  applied.notes = taken->doubts;
  applied.state[part::registration] = std::move(taken);
  applied.state[part::other_registration] = std::make_shared<const OtherRegistration>(std::move(former));
  return applied;
}

}  // namespace glisson::engine
