// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

#include "glisson/core/random.h"

namespace glisson::insilico {

/// Seeded numbers that do not depend on the standard library's distributions.
class Hand {
 public:
  explicit Hand(std::uint64_t seed) : random_(seed * 6364136223846793005ULL + 1442695040888963407ULL) {}

  double uniform() { return uniform01(random_); }
  std::size_t draw(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  double tremor() { return standard_normal(random_); }
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
