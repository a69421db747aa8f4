// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "glisson/core/run_context.h"
#include "live_stage.h"
#include "real_pairs.h"

namespace glisson::experiments {

/// A real pair set in motion: the surface that it shows (the stage's own reconstruction) is moved in a known
/// way, and each view is drawn anew from its own picture. So texture, highlights and blur are a real
/// laparoscope's and the motion is known; but highlights and light move with the tissue, which they do not in
/// a patient, and nothing comes in front. The model is a slab of 24 mm below that surface, its targets lie 5
/// to 20 mm deep. Before the laparoscope that stands the tissue breathes by 5 mm and is pressed in by 4; the
/// one in a hand turns by up to 10 degrees a second besides; in the third film a place of the tissue is
/// lifted by 30 mm in the second second, in the fourth a cut through it gapes by 15 mm then.
/// @param seed of the noise that each frame has of its own (two grey levels). Empty: cancelled.
/// @throws InputError the pair shows no surface.
Cancellable<LiveStage> pair_stage(const RealPair& pair, int frames, std::uint64_t seed,
                                  const RunContext& context);

}  // namespace glisson::experiments
