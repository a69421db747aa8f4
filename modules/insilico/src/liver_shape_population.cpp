// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/run_context.h"
#include "liver_shape.h"

namespace glisson::insilico {

ShapeParameters draw_shape(std::uint64_t seed) {
  Dice dice(RunContext({}, nullptr, seed).random("insilico.liver_shape"));
  ShapeParameters s;
  s.seed = seed;
  s.volume_ml = dice.between(1420, 1780);
  s.right_width = dice.between(72, 80);
  s.right_depth = dice.between(80, 88);
  s.right_height = dice.between(106, 118);
  s.left_width = dice.between(72, 90);
  s.left_depth = dice.between(46, 54);
  s.left_height = dice.between(54, 66);
  s.left_reach = dice.between(2, 12);
  s.slope_right = dice.between(0.44, 0.56);
  s.slope_left = dice.between(0.28, 0.40);
  s.slope_anterior = dice.between(0.32, 0.42);
  s.hollow = dice.between(0.0017, 0.0026);
  s.notch_x = dice.between(-2, 14);
  s.notch_depth = dice.between(16, 26);
  s.bladder_x = dice.between(-54, -40);
  s.bladder_length = dice.between(52, 68);
  s.cava_radius = dice.between(10.5, 12.5);
  // Volume grows a little slower than the cube of the half axes (the visceral surface stays); three steps
  // suffice.
  for (int step = 0; step < 4; ++step) {
    const double now = liver_volume_ml(LiverShape(s), 6.0);
    s.size *= std::cbrt(s.volume_ml / now);
  }
  return s;
}

}  // namespace glisson::insilico
