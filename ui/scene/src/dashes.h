// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QLineF>
#include <QPolygonF>

class QPainter;

namespace glisson::scene {

/// How a dashed line looks: dark below light, so that it is seen on any tissue.
struct Dashes {
  QColor colour, below;
  double width = 1.5;           ///< pixels
  double rim = 1.0;             ///< pixels of `below` on either side
  double on = 4, off = 3;       ///< widths
  bool is_whole_below = false;  ///< what is below has no gaps
};

/// The dashes of a line as straight pieces: chords that leave it by less than a pixel's half, for lines that
/// bend no faster than a dash is long.
/// @param on, off lengths in pixels, positive.
QList<QLineF> dashes_of(const QPolygonF& line, bool is_closed, double on, double off);

/// Qt strokes a dashed path as one outline, which takes it milliseconds; straight pieces take it a tenth.
void draw_dashes(QPainter& painter, const QPolygonF& line, bool is_closed, const Dashes& dashes);

}  // namespace glisson::scene
