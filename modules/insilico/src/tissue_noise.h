// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace glisson::insilico {

/// Gradient noise (Perlin 2002, quintic fade) at n points at once: about -1 to 1, mean 0, feature size 1. The
/// lattice's gradients come from a hash, without tables, so that the loop runs in vector registers (chosen at
/// run time); every machine gives the same bits.
void gradient_noise(int n, const float* x, const float* y, const float* z, std::uint32_t seed, float* out);

}  // namespace glisson::insilico
