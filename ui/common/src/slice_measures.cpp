// SPDX-License-Identifier: GPL-3.0-or-later
#include "slice_measures.h"

#include <algorithm>

namespace glisson::ui {
namespace {

const QColor kColour(204, 255, 144);  // no structure has it

void paint_ends(QPainter& painter, const QLineF& line) {
  constexpr double kHalf = 4.0;  // pixels
  if (line.length() < 1.0) return;
  QLineF tick = line.normalVector();
  tick.setLength(kHalf);
  const QPointF aside = tick.p2() - tick.p1();
  painter.drawLine(line.p1() - aside, line.p1() + aside);
  painter.drawLine(line.p2() - aside, line.p2() + aside);
}

/// Right of the line's right end, or where there is room.
QRectF place_of(const QRectF& view, const QLineF& line, QSizeF size) {
  constexpr double kGap = 6.0;
  const QPointF end = line.p1().x() > line.p2().x() ? line.p1() : line.p2();
  QRectF box(QPointF(end.x() + kGap, end.y() - 0.5 * size.height()), size);
  box.moveLeft(std::clamp(box.left(), view.left(), std::max(view.left(), view.right() - size.width())));
  box.moveTop(std::clamp(box.top(), view.top(), std::max(view.top(), view.bottom() - size.height())));
  return box;
}

}  // namespace

void paint_measure(QPainter& painter, const QRectF& view, const QLineF& line,
                   const std::optional<QLineF>& across, const QString& number) {
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(QColor(0, 0, 0, 200), 3.5), QPen(kColour, 1.5)}) {
    painter.setPen(pen);
    painter.drawLine(line);
    paint_ends(painter, line);
    if (!across) continue;
    painter.drawLine(*across);
    paint_ends(painter, *across);
  }
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  const QSizeF size = painter.fontMetrics().size(Qt::TextSingleLine, number) + QSize(8, 4);
  const QRectF box = place_of(view, line, size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 150));
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.setPen(kColour);
  painter.drawText(box, Qt::AlignCenter, number);
  font.setBold(false);
  painter.setFont(font);
}

}  // namespace glisson::ui
