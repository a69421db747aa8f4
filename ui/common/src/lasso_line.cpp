// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/lasso_line.h"

#include <QPainter>

namespace glisson::ui {

LassoLine::LassoLine(QWidget* over) : QWidget(over) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setStyleSheet(QStringLiteral("background: transparent;"));
  hide();
}

void LassoLine::start(const QPointF& p) {
  line_ = {p};
  setGeometry(parentWidget()->rect());
  show();
  raise();
}

void LassoLine::extend(const QPointF& p) {
  line_ << p;
  update();
}

void LassoLine::clear() {
  line_.clear();
  hide();
}

void LassoLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_lasso(painter, line_);
}

void paint_lasso(QPainter& painter, const QPolygonF& line) {
  if (line.size() < 2) return;
  const QColor yellow(255, 230, 120);
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(QColor(0, 0, 0, 200), 3.5), QPen(yellow, 1.5)}) {
    painter.setPen(pen);
    painter.drawPolyline(line);
  }
  painter.setPen(QPen(yellow, 1.0, Qt::DashLine));
  painter.drawLine(line.last(), line.first());
}

}  // namespace glisson::ui
