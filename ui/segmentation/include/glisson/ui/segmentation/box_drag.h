// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "glisson/ui/scene/slice_picture.h"

namespace glisson::ui {

/// A drag in a slice that draws a box along the patient's axes, or moves what it took of one: an edge, or two
/// where they meet. Away from every edge it draws a new rectangle, as deep as the box was, else as the
/// volume. CT frame, metres. No widgets.
class BoxDrag {
 public:
  /// @param box that is there. @param bounds of the volume: no side lies beyond.
  /// @param start where the button was pressed. @param reach within which an edge is taken.
  BoxDrag(const std::optional<Eigen::AlignedBox3d>& box, const Eigen::AlignedBox3d& bounds,
          scene::Plane plane, const Eigen::Vector3d& start, double reach);

  /// The box with the pointer at a place (CT frame); the former one while that would draw a rectangle without
  /// width.
  std::optional<Eigen::AlignedBox3d> to(const Eigen::Vector3d& p) const;
  const std::optional<Eigen::AlignedBox3d>& former() const { return former_; }

 private:
  enum class Side { none, low, high };
  std::optional<Eigen::AlignedBox3d> former_;
  Eigen::AlignedBox3d bounds_;
  int normal_;
  Eigen::Vector3d start_;
  double reach_;
  std::array<Side, 3> taken_ = {Side::none, Side::none, Side::none};
};

}  // namespace glisson::ui
