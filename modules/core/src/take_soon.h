// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cerrno>

#include "glisson/core/claim.h"

namespace glisson {

/// A program that is killed while it starts another leaves a child that shares what it held until that
/// becomes the other program: a moment. Whoever holds it longer is at work.
/// @param waits how often `pause` may still be called. @return whether it is held now.
template <class Pause>
bool take_soon(const Claim& claim, int& waits, const Pause& pause) {
  while (!claim.take()) {
    if (errno != EWOULDBLOCK || waits-- <= 0) return false;
    pause();
  }
  return true;
}

}  // namespace glisson
