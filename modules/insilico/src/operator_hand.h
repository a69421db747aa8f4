// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace glisson::insilico {

/// Seeded numbers that do not depend on the standard library's distributions.
class Hand {
 public:
  explicit Hand(std::uint64_t seed) : random_(seed * 6364136223846793005ULL + 1442695040888963407ULL) {}

  double uniform() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }
  std::size_t draw(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  /// Standard normal (Box and Muller).
  double tremor() {
    const double u = uniform() + 0x1.0p-54;
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * uniform());
  }
  Eigen::Vector3d tremor3() {
    const double x = tremor(), y = tremor(), z = tremor();
    return {x, y, z};
  }
  Eigen::Vector2d tremor2() {
    const double x = tremor(), y = tremor();
    return {x, y};
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace glisson::insilico
