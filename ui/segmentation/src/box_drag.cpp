// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/box_drag.h"

#include <cmath>

namespace glisson::ui {

BoxDrag::BoxDrag(const std::optional<Eigen::AlignedBox3d>& box, const Eigen::AlignedBox3d& bounds,
                 scene::Plane plane, const Eigen::Vector3d& start, double reach)
    : former_(box),
      bounds_(bounds),
      normal_(scene::normal_axis(plane)),
      start_(start.cwiseMax(bounds.min()).cwiseMin(bounds.max())),
      reach_(reach) {
  if (!former_) return;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == normal_) continue;
    const int other = 3 - axis - normal_;
    const bool beside =
        start[other] >= former_->min()[other] - reach && start[other] <= former_->max()[other] + reach;
    const double low = std::abs(start[axis] - former_->min()[axis]),
                 high = std::abs(start[axis] - former_->max()[axis]);
    if (beside && std::min(low, high) <= reach)
      taken_[static_cast<std::size_t>(axis)] = low < high ? Side::low : Side::high;
  }
}

std::optional<Eigen::AlignedBox3d> BoxDrag::to(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d here = p.cwiseMax(bounds_.min()).cwiseMin(bounds_.max());
  Eigen::AlignedBox3d box = former_.value_or(bounds_);
  const bool draws = std::all_of(taken_.begin(), taken_.end(), [](Side side) { return side == Side::none; });
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == normal_) continue;
    const Side side = taken_[static_cast<std::size_t>(axis)];
    if (!draws && side == Side::none) continue;
    const double one = draws ? start_[axis] : side == Side::low ? box.max()[axis] : box.min()[axis];
    if (draws && std::abs(here[axis] - one) < reach_) return former_;
    box.min()[axis] = std::min(one, here[axis]);
    box.max()[axis] = std::max(one, here[axis]);
  }
  return box;
}

}  // namespace glisson::ui
