// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesion_card.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "glisson/ui/scene/colours.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "glisson/ui/scene/surface_raster.h"
#include "overlay_words.h"

namespace glisson::scene {
namespace {

QPointF on_picture(const Camera& camera, const Eigen::Vector3d& p) {
  const Eigen::Vector2d pixel = camera.project(p);
  return {pixel.x() + 0.5, pixel.y() + 0.5};
}

/// Twice: dark below, so that it is seen on any tissue.
template <class Draw>
void with_rim(QPainter& painter, const QColor& colour, double width, const Draw& draw) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 190), width + 2.0, Qt::SolidLine, Qt::FlatCap));
  draw();
  painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
  draw();
}

/// The corners of a square around the lesion: its body stays free.
void draw_brackets(QPainter& painter, const Layout& layout, const QPointF& middle, double half,
                   const QColor& colour) {
  const double leg = 0.4 * half;
  with_rim(painter, colour, std::max(1.5, layout.text / 8.0), [&] {
    for (const int x : {-1, 1})
      for (const int y : {-1, 1}) {
        const QPointF corner = middle + QPointF(x * half, y * half);
        painter.drawPolyline(
            QPolygonF({corner - QPointF(x * leg, 0.0), corner, corner - QPointF(0.0, y * leg)}));
      }
  });
}

void draw_place(QPainter& painter, const Layout& layout, const QPointF& place) {
  const double arm = 0.8 * layout.text;
  with_rim(painter, kWords, std::max(1.5, layout.text / 8.0), [&] {
    painter.drawLine(place - QPointF(arm, 0.0), place - QPointF(0.3 * arm, 0.0));
    painter.drawLine(place + QPointF(0.3 * arm, 0.0), place + QPointF(arm, 0.0));
    painter.drawLine(place - QPointF(0.0, arm), place - QPointF(0.0, 0.3 * arm));
    painter.drawLine(place + QPointF(0.0, 0.3 * arm), place + QPointF(0.0, arm));
    painter.drawEllipse(place, 0.6 * arm, 0.6 * arm);
  });
}

/// From the surface to the lesion, with a tick every 10 mm of the way.
void draw_ruler(QPainter& painter, const Layout& layout, const guidance::LesionMeasures& measures,
                const Camera& camera, const QColor& colour) {
  constexpr double kTick = 10e-3;
  const Eigen::Vector3d begin = measures.surface_end, end = measures.lesion_end;
  if (!(measures.shortest > 0.0) || !SurfaceRaster::is_mapped(camera, begin) ||
      !SurfaceRaster::is_mapped(camera, end))
    return;
  const QPointF from = on_picture(camera, begin), to = on_picture(camera, end);
  const double length = std::hypot(to.x() - from.x(), to.y() - from.y());
  const double half = 0.35 * layout.text;
  // Seen along itself a way has no direction on the picture: its ends are marked nevertheless.
  const QPointF across =
      length > 1.0 ? QPointF(-(to.y() - from.y()), to.x() - from.x()) * (half / length) : QPointF(half, 0.0);
  with_rim(painter, colour, std::max(1.5, layout.text / 8.0), [&] {
    painter.drawLine(from, to);
    for (double at = 0.0; at < measures.shortest; at += kTick) {
      const QPointF place = on_picture(camera, begin + (end - begin) * (at / measures.shortest));
      painter.drawLine(place - across, place + across);
    }
  });
}

}  // namespace

std::vector<std::pair<std::string, std::string>> lesion_numbers(const LesionVerdict& verdict,
                                                                const guidance::LesionMeasures& measures) {
  std::vector<std::pair<std::string, std::string>> rows;
  if (verdict.level == Level::withdrawn) return rows;
  const auto add = [&rows](const QString& name, double metres) {
    if (std::isfinite(metres)) rows.emplace_back(name.toStdString(), Overlay::length(metres).toStdString());
  };
  add(Overlay::along_sight(), measures.along_sight);
  add(Overlay::shortest(), measures.shortest);
  if (verdict.reach > 0.0) {
    add(Overlay::expected(), verdict.expected);
    rows.emplace_back(Overlay::within().toStdString(), Overlay::reach(verdict.reach).toStdString());
  }
  add(Overlay::from_place(), measures.from_place);
  return rows;
}

void draw_card_marks(QPainter& painter, const Layout& layout, const LesionCard& card, const Camera& camera,
                     bool with_ruler) {
  const Eigen::Vector3d& centre = card.verdict.centre;
  // A degraded one has its region.
  if (card.verdict.level == Level::valid && SurfaceRaster::is_mapped(camera, centre)) {
    const double half = 1.5 * card.verdict.radius * camera.matrix(0, 0) / centre.z() + layout.text;
    if (with_ruler) draw_ruler(painter, layout, card.measures, camera, kWords);
    draw_brackets(painter, layout, on_picture(camera, centre), half, colour_of(card.verdict.lesion));
  }
  if (card.place) draw_place(painter, layout, QPointF(card.place->x() + 0.5, card.place->y() + 0.5));
}

void draw_card(QPainter& painter, const Layout& layout, Taken& taken, const LesionCard& card) {
  std::vector<std::pair<QString, QString>> rows;
  for (const auto& [name, value] : lesion_numbers(card.verdict, card.measures))
    rows.emplace_back(QString::fromStdString(name), QString::fromStdString(value));
  const QFont font = layout.font(), bold = layout.font(true);
  const QFontMetrics metrics(font), strong(bold);
  const QString head = Overlay::lesion(card.verdict.lesion);
  const bool is_known = card.verdict.level == Level::valid;
  const QString why = is_known ? QString() : Overlay::state(card.verdict.level);
  int names = 0, values = 0;
  for (const auto& [name, value] : rows) {
    names = std::max(names, metrics.horizontalAdvance(name));
    values = std::max(values, strong.horizontalAdvance(value));
  }
  const int gap = layout.text, row = metrics.height() + 2;
  const int width =
      std::max({names + gap + values, strong.horizontalAdvance(head), metrics.horizontalAdvance(why)});
  const int lines = static_cast<int>(rows.size()) + 1 + (why.isEmpty() ? 0 : 1);
  QRect box(0, 0, width + 2 * layout.margin, lines * row + layout.margin);
  box.moveRight(layout.size.width() - layout.margin);
  box.moveBottom(layout.size.height() - layout.margin - 3 * layout.text);
  box = taken.above(box).toRect();
  draw_plate(painter, box);
  const int left = box.left() + layout.margin;
  int top = box.top() + layout.margin / 2;
  const auto line = [&](const QFont& of, const QColor& pen, Qt::Alignment side, const QString& text) {
    painter.setFont(of);
    painter.setPen(pen);
    painter.drawText(QRect(left, top, width, row), side | Qt::AlignVCenter, text);
  };
  line(bold, colour_of(card.verdict.lesion), Qt::AlignLeft, head);
  top += row;
  if (!why.isEmpty()) {
    line(font, kAmber, Qt::AlignLeft, why);
    top += row;
  }
  for (const auto& [name, value] : rows) {
    line(font, kWords, Qt::AlignLeft, name);
    line(bold, is_known ? kWords : kAmber, Qt::AlignRight, value);
    top += row;
  }
}

}  // namespace glisson::scene
