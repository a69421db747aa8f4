// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "glisson/patient/picture.h"

namespace glisson::scene {

/// A picture on its way: blue, green and red, in bytes of its own, so that each step draws where the one
/// before has drawn.
struct Canvas {
  int width = 0, height = 0;
  std::shared_ptr<std::vector<std::uint8_t>> bytes;
};

/// The one copy that a drawn picture costs.
Canvas canvas_of(const Picture& picture);
inline Picture picture_of(Canvas canvas) { return {canvas.width, canvas.height, 3, std::move(canvas.bytes)}; }

}  // namespace glisson::scene
