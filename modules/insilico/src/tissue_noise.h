// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace glisson::insilico {

/// How points are carried onto the noise's lattice: q = turn * p + shift, row by row.
struct Lattice {
  float turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  float shift[3] = {0, 0, 0};
  std::uint32_t seed = 0;
};

/// Gradient noise (Perlin 2002, quintic fade) at n points at once: about -1 to 1, mean 0, feature size 1. The
/// lattice's gradients come from a hash, without tables, so that the loop runs in vector registers (chosen at
/// run time); every machine gives the same bits.
void gradient_noise(int n, const float* x, const float* y, const float* z, const Lattice& lattice,
                    float* out);

}  // namespace glisson::insilico
