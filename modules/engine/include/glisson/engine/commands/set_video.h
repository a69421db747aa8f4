// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/command.h"

namespace glisson::engine {

/// From now on the case's video is this one (`right` empty: `left` holds both views side by side), by a
/// person's word: it is remembered as chosen (stereo/reach.h).
struct SetVideo {
  std::filesystem::path left, right;

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
