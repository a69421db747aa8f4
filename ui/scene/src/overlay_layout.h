// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QSize>
#include <vector>

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

/// Where words stand already: no plate may cover another's words.
class Taken {
 public:
  explicit Taken(const Layout& layout)
      : room_(QPointF(0, 0), QSizeF(layout.size)), gap_(layout.margin / 3.0) {}
  void add(const QRectF& box) { boxes_.push_back(box); }
  /// The box, moved down (up) as far as is needed to stand free; it is taken then. Where the picture is full
  /// it stays where it was.
  QRectF below(const QRectF& box);
  QRectF above(const QRectF& box);
  /// A box beside what it speaks of, in the picture: over it, under it, right or left of it, wherever it
  /// stands free first; else moved down from over it.
  QRectF beside(const QRectF& what, const QSizeF& size);

 private:
  bool is_free(const QRectF& box) const;
  QRectF moved(QRectF box, bool down);

  QRectF room_;
  double gap_;
  std::vector<QRectF> boxes_;
};

/// What words stand on.
void draw_plate(QPainter& painter, const QRectF& box);
/// Text on a dark plate; `anchor` is one of the picture's corners, from which it moves away where others
/// stand.
void draw_text(QPainter& painter, const Layout& layout, Taken& taken, const QString& text, const QFont& font,
               const QColor& colour, Qt::Alignment anchor);

}  // namespace glisson::scene
