// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/run_context.h"
#include "liver_shape.h"

namespace glisson::insilico {

ShapeParameters draw_shape(std::uint64_t seed) {
  Dice dice(RunContext({}, nullptr, seed).random("insilico.liver_shape"));
  ShapeParameters s;
  s.seed = seed;
  s.volume_ml = dice.between(1420, 1780);
  s.right_width = dice.between(70, 84);
  s.right_depth = dice.between(76, 90);
  s.right_height = dice.between(98, 122);
  s.left_width = dice.between(66, 96);
  s.left_depth = dice.between(45, 58);
  s.left_height = dice.between(54, 74);
  s.left_reach = dice.between(0, 16);
  s.saddle = dice.between(38, 56);
  s.slope_right = dice.between(0.40, 0.60);
  s.slope_left = dice.between(0.24, 0.42);
  s.slope_anterior = dice.between(0.30, 0.44);
  s.hollow = dice.between(0.0014, 0.0027);
  s.lift = dice.between(-8, 8);
  s.notch_x = dice.between(-8, 18);
  s.notch_depth = dice.between(17, 28);
  s.bladder_x = dice.between(-58, -38);
  s.bladder_length = dice.between(50, 70);
  s.cava_radius = dice.between(10.5, 12.5);
  // The visceral surface does not grow with the half axes, so the volume grows more slowly than their cube:
  // a few corrections are needed.
  for (int step = 0; step < 6; ++step) {
    const double now = liver_volume_ml(LiverShape(s), 6.0);
    s.size *= std::cbrt(s.volume_ml / now);
  }
  return s;
}

}  // namespace glisson::insilico
