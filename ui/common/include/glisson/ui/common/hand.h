// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Qt>
#include <optional>

#include "glisson/core/frames.h"
#include "glisson/geometry/mesh.h"
#include "glisson/ui/scene/slice_picture.h"
#include "glisson/volume/label_volume.h"

namespace glisson::ui {

/// What the left mouse button does in the views.
enum class Hand {
  crosshair,  ///< moves the crosshair
  point,      ///< says where: a seed, a place to work at
  span,       ///< the same, or is dragged from one end of a body to the other
  brush,      ///< is dragged with a brush at its tip
  lasso,      ///< draws a closed line; in three dimensions, too
  box         ///< drags a rectangle, or an edge of the box that is shown
};

/// The brush as it is drawn at the pointer.
struct BrushTip {
  double radius = 5e-3;  ///< metres
  bool ball = false;     ///< or a disc in the slice
  Label label = 0;       ///< gives the colour
  bool operator==(const BrushTip&) const = default;
};

/// One moment of a drag, or of a click, in a slice.
struct SliceGesture {
  enum class Phase { begin, move, end };
  Phase phase = Phase::begin;
  scene::SliceGeometry slice;
  Point<CtFrame> p;
  Qt::KeyboardModifiers keys;
  double reach = 2e-3;  ///< metres within which the pointer takes what it points at
};

/// A closed line that was drawn over the 3D view.
struct VolumeLasso {
  /// Homogeneous CT point (metres) to homogeneous view place; third component <= 0 behind the viewer.
  Eigen::Matrix<double, 3, 4> view_from_ct = Eigen::Matrix<double, 3, 4>::Zero();
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> outline;  ///< [0, 1] from the top left corner
  Qt::KeyboardModifiers keys;
};

/// Where the pointer is.
struct PointerPlace {
  scene::Plane plane = scene::Plane::axial;
  Point<CtFrame> p;
};

/// A closed line in the slice that a place lies in.
struct SliceLine {
  PointerPlace place;
  Points corners;     ///< CT frame, metres
  Label label = 0;    ///< gives the colour
  bool open = false;  ///< it runs along the slice's edge: drawn dashed
};

}  // namespace glisson::ui
