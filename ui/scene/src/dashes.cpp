// SPDX-License-Identifier: GPL-3.0-or-later
#include "dashes.h"

#include <QPainter>
#include <cmath>

#include "glisson/core/error.h"

namespace glisson::scene {
namespace {

constexpr double kBow = 0.5;  ///< pixels between a chord and its line

/// A line that is walked along.
class Walk {
 public:
  Walk(const QPolygonF& line, bool is_closed) : line_(line), segments_(line.size() - (is_closed ? 0 : 1)) {}
  /// Goes on by so much. @return whether the line is that long; else it ends where it ends.
  bool advance(double pixels) {
    while (segment_ < segments_) {
      const double rest = length() - along_;
      if (pixels < rest) {
        along_ += pixels;
        return true;
      }
      pixels -= rest;
      along_ = 0.0;
      ++segment_;
    }
    return false;
  }
  QPointF here() const {
    if (segment_ >= segments_) return end(segments_);
    const double whole = length();
    return begin() + (whole > 0.0 ? along_ / whole : 0.0) * (end(segment_ + 1) - begin());
  }

 private:
  QPointF begin() const { return end(segment_); }
  QPointF end(qsizetype i) const { return line_[i % line_.size()]; }
  double length() const { return QLineF(begin(), end(segment_ + 1)).length(); }

  const QPolygonF& line_;
  qsizetype segments_, segment_ = 0;
  double along_ = 0.0;  ///< pixels, of the segment
};

QList<QLineF> segments_of(const QPolygonF& line, bool is_closed) {
  QList<QLineF> segments;
  for (qsizetype i = 0; i + (is_closed ? 0 : 1) < line.size(); ++i)
    segments << QLineF(line[i], line[(i + 1) % line.size()]);
  return segments;
}

}  // namespace

QList<QLineF> dashes_of(const QPolygonF& line, bool is_closed, double on, double off) {
  require(on > 0.0 && off > 0.0, "dashes and what is between them have a length");
  QList<QLineF> dashes;
  if (line.size() < 2) return dashes;
  Walk walk(line, is_closed);
  for (bool goes_on = true; goes_on;) {
    const QPointF from = walk.here();
    goes_on = walk.advance(0.5 * on);
    const QPointF middle = walk.here();
    if (!goes_on) {
      dashes << QLineF(from, middle);
      break;
    }
    goes_on = walk.advance(0.5 * on);
    const QPointF to = walk.here();
    const QPointF bow = middle - 0.5 * (from + to);
    if (std::hypot(bow.x(), bow.y()) < kBow)
      dashes << QLineF(from, to);
    else
      dashes << QLineF(from, middle) << QLineF(middle, to);
    goes_on = goes_on && walk.advance(off);
  }
  return dashes;
}

void draw_dashes(QPainter& painter, const QPolygonF& line, bool is_closed, const Dashes& dashes) {
  const QList<QLineF> pieces =
      dashes_of(line, is_closed, dashes.on * dashes.width, dashes.off * dashes.width);
  const auto draw = [&](const QList<QLineF>& lines, const QColor& colour, double width) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(lines);
  };
  draw(dashes.is_whole_below ? segments_of(line, is_closed) : pieces, dashes.below,
       dashes.width + 2.0 * dashes.rim);
  draw(pieces, dashes.colour, dashes.width);
}

}  // namespace glisson::scene
