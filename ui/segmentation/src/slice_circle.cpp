// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/slice_circle.h"

#include <cmath>
#include <utility>

namespace glisson::ui {

std::shared_ptr<const SliceLine> line_of(const SliceCircle& circle, const SliceGesture& gesture,
                                         Label label) {
  SliceLine line{{gesture.slice.plane, gesture.p}, Points(circle.corners, 3), label, false};
  for (int n = 0; n < circle.corners; ++n) {
    const double angle = 2.0 * M_PI * n / circle.corners;
    line.corners.row(n) =
        (circle.middle + circle.radius * (std::cos(angle) * circle.u + std::sin(angle) * circle.v))
            .transpose();
  }
  return std::make_shared<const SliceLine>(std::move(line));
}

}  // namespace glisson::ui
