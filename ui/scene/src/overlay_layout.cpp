// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_layout.h"

#include <algorithm>
#include <utility>

namespace glisson::scene {

QFont Layout::font(bool bold, double scale) const {
  QFont chosen(QStringLiteral("DejaVu Sans"));
  chosen.setStyleHint(QFont::SansSerif);
  chosen.setPixelSize(std::max(8, static_cast<int>(text * scale)));
  chosen.setBold(bold);
  return chosen;
}

bool Taken::is_free(const QRectF& box) const {
  return std::none_of(boxes_.begin(), boxes_.end(),
                      [&](const QRectF& other) { return box.intersects(other); });
}

QRectF Taken::moved(QRectF box, bool down) {
  const QRectF wanted = box;
  // Each step passes one box: there are no more steps than boxes.
  for (std::size_t step = 0; step <= boxes_.size(); ++step) {
    const auto other = std::find_if(boxes_.begin(), boxes_.end(),
                                    [&](const QRectF& taken) { return box.intersects(taken); });
    if (other == boxes_.end()) break;
    if (down)
      box.moveTop(other->bottom() + gap_);
    else
      box.moveBottom(other->top() - gap_);
  }
  if (box.top() < room_.top() || box.bottom() > room_.bottom()) box = wanted;
  add(box);
  return box;
}

QRectF Taken::below(const QRectF& box) { return moved(box, true); }
QRectF Taken::above(const QRectF& box) { return moved(box, false); }

QRectF Taken::beside(const QRectF& what, const QSizeF& size) {
  const auto around = [&](double x, double y) {
    QRectF box(QPointF(0, 0), size);
    box.moveCenter(what.center() + QPointF(x * (0.5 * (what.width() + size.width()) + gap_),
                                           y * (0.5 * (what.height() + size.height()) + gap_)));
    box.moveLeft(std::clamp(box.left(), room_.left(), std::max(room_.left(), room_.right() - box.width())));
    box.moveTop(std::clamp(box.top(), room_.top(), std::max(room_.top(), room_.bottom() - box.height())));
    return box;
  };
  for (const auto& [x, y] : {std::pair{0, -1}, std::pair{0, 1}, std::pair{1, 0}, std::pair{-1, 0}})
    if (const QRectF box = around(x, y); is_free(box)) {
      add(box);
      return box;
    }
  return below(around(0, -1));
}

void draw_plate(QPainter& painter, const QRectF& box) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(12, 16, 20, 190));
  painter.drawRoundedRect(box, 4.0, 4.0);
}

void draw_text(QPainter& painter, const Layout& layout, Taken& taken, const QString& text, const QFont& font,
               const QColor& colour, Qt::Alignment anchor) {
  const QFontMetrics metrics(font);
  const int pad = layout.margin / 2;
  QRectF box(0, 0, metrics.horizontalAdvance(text) + 2 * pad, metrics.height() + pad);
  box.moveLeft(anchor & Qt::AlignRight     ? layout.size.width() - layout.margin - box.width()
               : anchor & Qt::AlignHCenter ? (layout.size.width() - box.width()) / 2
                                           : layout.margin);
  const bool at_bottom = anchor & Qt::AlignBottom;
  box.moveTop(at_bottom ? layout.size.height() - layout.margin - box.height() : layout.margin);
  box = at_bottom ? taken.above(box) : taken.below(box);
  draw_plate(painter, box);
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace glisson::scene
