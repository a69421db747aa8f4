// SPDX-License-Identifier: GPL-3.0-or-later
#include "slice_texts.h"

#include "glisson/ui/common/slice_view.h"

namespace glisson::ui {

QColor plane_colour(scene::Plane plane) {
  switch (plane) {
    case scene::Plane::axial:
      return {239, 83, 80};
    case scene::Plane::coronal:
      return {102, 187, 106};
    case scene::Plane::sagittal:
      return {255, 202, 40};
  }
  return {};
}

void draw_outlined(QPainter& painter, const QRectF& box, Qt::Alignment alignment, const QString& text,
                   const QColor& colour) {
  painter.setPen(QColor(0, 0, 0, 210));
  for (const QPointF& shift : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)})
    painter.drawText(box.translated(shift), static_cast<int>(alignment), text);
  painter.setPen(colour);
  painter.drawText(box, static_cast<int>(alignment), text);
}

void paint_texts(QPainter& painter, const QRectF& view, const scene::SliceGeometry& slice,
                 const QString& shown, const QString& slab) {
  const QRectF area = view.adjusted(8, 6, -8, -6);
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  const scene::EdgeLetters letters = scene::edge_letters(slice.plane);
  const QColor white(238, 241, 243);
  const auto letter = [&](Qt::Alignment side, char which) {
    draw_outlined(painter, area, side, QString(QLatin1Char(which)), white);
  };
  letter(Qt::AlignLeft | Qt::AlignVCenter, letters.left);
  letter(Qt::AlignRight | Qt::AlignVCenter, letters.right);
  letter(Qt::AlignHCenter | Qt::AlignTop, letters.top);
  letter(Qt::AlignHCenter | Qt::AlignBottom, letters.bottom);
  const QString name = slice.plane == scene::Plane::axial     ? SliceView::tr("Axial")
                       : slice.plane == scene::Plane::coronal ? SliceView::tr("Coronal")
                                                              : SliceView::tr("Sagittal");
  draw_outlined(painter, area, Qt::AlignLeft | Qt::AlignTop, name, plane_colour(slice.plane));
  font.setBold(false);
  painter.setFont(font);
  const int axis = scene::normal_axis(slice.plane);
  const QString where = SliceView::tr("%1 mm").arg(
      QString::fromStdString(scene::anatomical_coordinate(axis, slice.origin[axis])));
  draw_outlined(painter, area, Qt::AlignRight | Qt::AlignTop, where, white);
  // In a narrow view the line would reach the lower edge's letter: then it stands above that.
  const QFontMetrics metrics = painter.fontMetrics();
  const bool is_wide = metrics.horizontalAdvance(shown) + 2 * metrics.height() < 0.5 * area.width();
  const QRectF lower = is_wide ? area : area.adjusted(0, 0, 0, -metrics.height());
  draw_outlined(painter, lower, Qt::AlignLeft | Qt::AlignBottom, shown, QColor(190, 198, 204));
  if (slab.isEmpty()) return;
  font.setBold(true);
  painter.setFont(font);
  draw_outlined(painter, lower.adjusted(0, 0, 0, -painter.fontMetrics().height()),
                Qt::AlignLeft | Qt::AlignBottom, slab, QColor(255, 183, 77));
}

}  // namespace glisson::ui
