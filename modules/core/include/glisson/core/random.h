// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <random>

/// @file
/// Random numbers that are the same everywhere: the standard fixes its generators, not its distributions.

namespace glisson {

/// Uniform in [0, 1), 53 bits.
inline double uniform01(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

/// Standard normal (Box and Muller 1958); two numbers of the generator each.
inline double standard_normal(std::mt19937_64& random) {
  const double radius = std::sqrt(-2.0 * std::log(uniform01(random) + 0x1.0p-54));
  return radius * std::cos(2.0 * std::numbers::pi * uniform01(random));
}

/// Three of them, drawn from the last coordinate to the first. An argument list has no order of its own, and
/// compilers draw in different ones: never two draws in one.
inline Eigen::Vector3d standard_normal3(std::mt19937_64& random) {
  const double z = standard_normal(random), y = standard_normal(random), x = standard_normal(random);
  return {x, y, z};
}

}  // namespace glisson
