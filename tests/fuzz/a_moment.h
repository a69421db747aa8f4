// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/parts/moments.h"

namespace glisson::fuzz {

/// A kept moment, of whose pictures there are a few bytes only.
engine::KeptMoment a_moment();

}  // namespace glisson::fuzz
