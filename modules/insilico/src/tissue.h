// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "implicit.h"

namespace glisson::insilico {

/// Where the vena cava ends in the right atrium, z in mm.
inline constexpr double kCavaTop = 104.0;

/// Hounsfield units in the portal venous phase.
namespace tissue {
inline constexpr double kAir = -1000, kLung = -840, kFat = -102, kInnerFat = -96, kSkin = 15, kMuscle = 60;
inline constexpr double kLiver = 110, kPortal = 172, kHepatic = 162, kCava = 150, kTumour = 65, kBile = 10;
inline constexpr double kSpleen = 120, kCortex = 195, kMedulla = 165, kPelvis = -20, kPancreas = 104;
inline constexpr double kHeart = 122, kAorta = 168, kBowelWall = 100, kBowelContent = 98, kStomach = 99;
inline constexpr double kCortical = 380, kMarrow = 190, kDisc = 85, kCanal = 25, kCartilage = 115;
}  // namespace tissue

/// Smooth pseudo-random mottle of about unit standard deviation with cells of `cell` mm.
inline double mottle(const Vec& p, double cell, std::uint64_t seed) {
  const Vec q = p / cell;
  const Vec base(std::floor(q.x()), std::floor(q.y()), std::floor(q.z()));
  const Vec t = q - base;
  const Vec w(t.x() * t.x() * (3 - 2 * t.x()), t.y() * t.y() * (3 - 2 * t.y()),
              t.z() * t.z() * (3 - 2 * t.z()));
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int dx = corner & 1, dy = (corner >> 1) & 1, dz = corner >> 2;
    const auto x = static_cast<std::uint64_t>(static_cast<std::int64_t>(base.x()) + dx + 4096);
    const auto y = static_cast<std::uint64_t>(static_cast<std::int64_t>(base.y()) + dy + 4096);
    const auto z = static_cast<std::uint64_t>(static_cast<std::int64_t>(base.z()) + dz + 4096);
    const std::uint64_t h = hash_of(seed * 0x100000001b3ULL ^ (x | (y << 16) | (z << 32)));
    const double value = static_cast<double>(h >> 11) * 0x1.0p-52 - 1.0;
    sum += value * (dx ? w.x() : 1 - w.x()) * (dy ? w.y() : 1 - w.y()) * (dz ? w.z() : 1 - w.z());
  }
  return 3.0 * sum;
}

}  // namespace glisson::insilico
