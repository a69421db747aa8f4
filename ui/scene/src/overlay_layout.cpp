// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_layout.h"

#include <algorithm>

namespace glisson::scene {

QFont Layout::font(bool bold, double scale) const {
  QFont chosen(QStringLiteral("DejaVu Sans"));
  chosen.setStyleHint(QFont::SansSerif);
  chosen.setPixelSize(std::max(8, static_cast<int>(text * scale)));
  chosen.setBold(bold);
  return chosen;
}

void draw_plate(QPainter& painter, const QRectF& box) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(12, 16, 20, 190));
  painter.drawRoundedRect(box, 4.0, 4.0);
}

void draw_text(QPainter& painter, const Layout& layout, const QString& text, const QFont& font,
               const QColor& colour, Qt::Alignment anchor) {
  const QFontMetrics metrics(font);
  const int pad = layout.margin / 2;
  QRect box(0, 0, metrics.horizontalAdvance(text) + 2 * pad, metrics.height() + pad);
  box.moveLeft(anchor & Qt::AlignRight     ? layout.size.width() - layout.margin - box.width()
               : anchor & Qt::AlignHCenter ? (layout.size.width() - box.width()) / 2
                                           : layout.margin);
  box.moveTop(anchor & Qt::AlignBottom ? layout.size.height() - layout.margin - box.height() : layout.margin);
  draw_plate(painter, box);
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace glisson::scene
