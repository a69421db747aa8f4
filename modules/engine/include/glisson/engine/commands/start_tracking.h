// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/command.h"
#include "glisson/guidance/tracker.h"

namespace glisson::engine {

/// From now on frames, or clouds, are followed (see Engine::submit_frame). For frames, the frame part is the
/// one that was registered.
struct StartTracking {
  enum class Source { frames, clouds };
  Source source = Source::frames;
  guidance::TrackerOptions options;
  int steps_per_cloud = 50;  ///< implicit Euler steps towards each cloud

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
