// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cerrno>

#include "glisson/core/claim.h"

namespace glisson {

/// Takes a claim, with a few tries. A process killed between fork and exec leaves a child that briefly
/// inherits the lock. A lock held longer than that belongs to a live process.
/// @param waits how often `pause` may still be called. @return whether the claim is taken now.
template <class Pause>
bool take_soon(const Claim& claim, int& waits, const Pause& pause) {
  while (!claim.take()) {
    if (errno != EWOULDBLOCK || waits-- <= 0) return false;
    pause();
  }
  return true;
}

}  // namespace glisson
