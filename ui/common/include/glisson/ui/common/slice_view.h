// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

#include "glisson/ui/common/view_state.h"

namespace glisson::ui {

/// One anatomical slice with labels, crosshair, markers and orientation letters. Left click or drag:
/// crosshair (or place a point while picking); right drag: grey window; middle drag: move; wheel: next slice;
/// Ctrl + wheel: zoom; double click: whole picture.
class SliceView : public QWidget {
  Q_OBJECT
 public:
  SliceView(ViewState& state, scene::Plane plane, QWidget* parent = nullptr);

  scene::Plane plane() const { return plane_; }
  /// The slice that is shown. Zero-sized while there is no volume.
  const scene::SliceGeometry& geometry_in_ct() const { return slice_; }
  const Picture& slice() const { return picture_; }
  /// Where a point of the patient appears.
  QPointF widget_point(const Point<CtFrame>& p) const;
  QSize sizeHint() const override { return {360, 320}; }
  QSize minimumSizeHint() const override { return {160, 140}; }

 signals:
  /// The pointer is over this place of the patient.
  void hovered(const glisson::Point<glisson::CtFrame>& p);
  void left_view();
  void slice_changed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void refresh_slice();
  void step(int slices);
  QTransform widget_from_pixel() const;
  Point<CtFrame> p_in_ct(const QPointF& widget) const;
  void paint_marks(QPainter& painter) const;
  void paint_texts(QPainter& painter) const;

  ViewState& state_;
  scene::Plane plane_;
  scene::SliceGeometry slice_;
  Picture picture_;
  QImage image_;
  double zoom_ = 1.0;
  QPointF pan_;
  QPointF last_;
  double wheel_rest_ = 0.0;
};

}  // namespace glisson::ui
