// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <QPolygonF>
#include <QTransform>

#include "glisson/ui/scene/slice_picture.h"

class QColor;
class QPainter;

/// @file
/// Lines over a slice, in the widget's pixels.

namespace glisson::ui {

/// A box along the patient's axes (CT frame, metres) where the slice meets it; dashed where the slice passes
/// it by. @param handles corners and edges show that they can be taken.
void paint_box(QPainter& painter, const Eigen::AlignedBox3d& box, const scene::SliceGeometry& slice,
               const QTransform& widget_from_pixel, bool handles);

/// A closed line that stands out from any grey. @param open drawn dashed.
void paint_outline(QPainter& painter, const QPolygonF& outline, const QColor& colour, bool open);

}  // namespace glisson::ui
