// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/patient/picture.h"
#include "stereo_proof.h"

namespace glisson::experiments {

/// The picture with what makes matching hard. Grey levels; the same on every run for a seed.
struct Hardship {
  double noise = 0.0;    ///< standard deviation, added to the theatre's own
  double texture = 1.0;  ///< contrast of what is finer than 8 pixels
  int highlights = 0;    ///< white spots, in other places in each view, as mirrors show them
};
Picture hardened(const Picture& picture, const Hardship& hardship, std::uint64_t seed);

/// A disk of colour (blue, green, red).
struct Dot {
  double x = 0.0, y = 0.0;
  std::uint8_t blue = 0, green = 0, red = 0;
};
/// The picture in grey with the dots over it.
Picture with_dots(const Picture& picture, const std::vector<Dot>& dots);

/// Error against depth, noise, texture and highlights: fills table and "theatre_" figures.
/// @return false: cancelled.
bool prove_in_theatre(const StereoProofOptions& options, const std::filesystem::path& folder,
                      StereoProof& proof, const RunContext& context);

}  // namespace glisson::experiments
