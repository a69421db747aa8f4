// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/slice_lines.h"

#include <QPainter>

namespace glisson::ui {

void paint_box(QPainter& painter, const Eigen::AlignedBox3d& box, const scene::SliceGeometry& slice,
               const QTransform& widget_from_pixel, bool handles) {
  const Eigen::Vector2d a = slice.pixel_of(Point<CtFrame>(box.min())),
                        b = slice.pixel_of(Point<CtFrame>(box.max()));
  const QRectF frame =
      widget_from_pixel.mapRect(QRectF(QPointF(a.x(), a.y()), QPointF(b.x(), b.y())).normalized());
  const int axis = scene::normal_axis(slice.plane);
  const bool met = slice.origin[axis] >= box.min()[axis] && slice.origin[axis] <= box.max()[axis];
  const QColor colour(79, 195, 247);  // no structure has it
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 200), 3.0));
  painter.drawRect(frame);
  painter.setPen(QPen(colour, 1.5, met ? Qt::SolidLine : Qt::DashLine));
  painter.drawRect(frame);
  if (!handles) return;
  painter.setPen(QPen(Qt::black, 1.0));
  painter.setBrush(colour);
  constexpr double kHalf = 3.5;
  for (const double x : {frame.left(), frame.center().x(), frame.right()})
    for (const double y : {frame.top(), frame.center().y(), frame.bottom()})
      if (QPointF(x, y) != frame.center())
        painter.drawRect(QRectF(x - kHalf, y - kHalf, 2 * kHalf, 2 * kHalf));
}

void paint_outline(QPainter& painter, const QPolygonF& outline, const QColor& colour, bool open) {
  if (outline.size() < 3) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 200), 3.0));
  painter.drawPolygon(outline);
  painter.setPen(QPen(colour, 1.5, open ? Qt::DashLine : Qt::SolidLine));
  painter.drawPolygon(outline);
}

}  // namespace glisson::ui
