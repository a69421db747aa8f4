// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "glisson/engine/command.h"
#include "glisson/fem/composite_model.h"
#include "glisson/guidance/tracker.h"

namespace glisson::engine {

/// A person's own network that says what is not liver (network/live_mask.h).
struct MaskChoice {
  std::filesystem::path network;  ///< ONNX, its sheet beside it; empty: none
  /// 0: beside the live loop, the newest picture wins. Otherwise a film is followed: every so many frames are
  /// masked and waited for, so that any machine finds the same; a network that cannot be opened is an error.
  int every = 0;
};

/// From now on frames, or clouds, are followed (see Engine::submit_frame). For frames, the frame part is the
/// one that was registered.
struct StartTracking {
  /// Frames of any stereo source, those of the case's video, or clouds.
  enum class Source { frames, video, clouds };
  Source source = Source::frames;
  /// Materials, and of `cloud` final stiffening and tangential share, are those of the model
  /// (registration::options_for), whatever is said here.
  guidance::TrackerOptions options;
  /// What the liver is made of; empty: as in a registration the model decides. What the case says
  /// of the lesions holds over it.
  std::optional<fem::CompositeOptions> materials;
  MaskChoice mask;           ///< of frames
  int steps_per_cloud = 50;  ///< implicit Euler steps towards each cloud

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context,
                             const Services& services) const;
};

}  // namespace glisson::engine
