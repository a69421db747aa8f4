// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QSize>

namespace glisson::scene {

inline const QColor kAmber(255, 176, 0);
inline const QColor kWords(225, 230, 233);

/// Sizes that follow the picture's.
struct Layout {
  explicit Layout(const QSize& picture)
      : size(picture), text(std::max(9, picture.height() / 42)), margin(std::max(6, picture.height() / 60)) {}
  QSize size;
  int text, margin;
  QFont font(bool bold = false, double scale = 1.0) const;
};

/// What words stand on.
void draw_plate(QPainter& painter, const QRectF& box);
/// Text on a dark plate; `anchor` is one of the picture's corners.
void draw_text(QPainter& painter, const Layout& layout, const QString& text, const QFont& font,
               const QColor& colour, Qt::Alignment anchor);

}  // namespace glisson::scene
