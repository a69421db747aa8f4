// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>

namespace glisson::ui {

/// A closed line drawn over another widget, which keeps the mouse: OpenGL views cannot be painted upon.
class LassoLine : public QWidget {
 public:
  explicit LassoLine(QWidget* over);
  const QPolygonF& line() const { return line_; }
  void start(const QPointF& p);
  void extend(const QPointF& p);
  void clear();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPolygonF line_;  ///< pixels of the widget
};

/// How every lasso looks: the line, and dashed what would close it.
void paint_lasso(QPainter& painter, const QPolygonF& line);

}  // namespace glisson::ui
