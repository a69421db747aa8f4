// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPainter>
#include <QString>

#include "glisson/ui/scene/slice_picture.h"

namespace glisson::ui {

/// Of the plane's traces in the other slices.
QColor plane_colour(scene::Plane plane);
/// Readable on any grey.
void draw_outlined(QPainter& painter, const QRectF& box, Qt::Alignment alignment, const QString& text,
                   const QColor& colour);
/// The patient's sides at the slice's edges, its name and place in the corners, and below on the left how it
/// is shown; above that, not to be overlooked, that it is more than a slice (may be empty).
void paint_texts(QPainter& painter, const QRectF& view, const scene::SliceGeometry& slice,
                 const QString& shown, const QString& slab);

}  // namespace glisson::ui
