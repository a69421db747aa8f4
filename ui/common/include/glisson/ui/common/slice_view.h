// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPolygonF>
#include <QWidget>

#include "glisson/ui/common/view_state.h"
#include "glisson/ui/scene/slice_drawing.h"

class QTimer;

namespace glisson::ui {

/// One anatomical slice with labels, previews, crosshair, markers, brush and orientation letters. Left click
/// or drag: what ViewState::hand() says; right drag: grey window; middle drag: move; wheel: next slice;
/// Ctrl + wheel: zoom; Shift + wheel: size of the brush, or of the
/// slab; double click: this view alone; right click: menu.
class SliceView : public QWidget {
  Q_OBJECT
 public:
  SliceView(ViewState& state, scene::Plane plane, QWidget* parent = nullptr);

  scene::Plane plane() const { return plane_; }
  /// The slice that is shown. Zero-sized while there is no volume.
  const scene::SliceGeometry& geometry_in_ct() const { return slice_; }
  const Picture& slice() const { return drawing_.picture(); }
  /// Where a point of the patient appears.
  QPointF widget_point(const Point<CtFrame>& p) const;
  /// What the slice's corner says of how it is shown: "Liver  WL 100  WW 180".
  QString shown_text() const;
  /// "MIP 10 mm" above it; empty: the slice alone is shown.
  QString slab_text() const;
  /// Takes zoom and shift away.
  void show_whole();
  QSize sizeHint() const override { return {360, 320}; }
  QSize minimumSizeHint() const override { return {160, 140}; }

 signals:
  /// The pointer is over this place of the patient.
  void hovered(const glisson::Point<glisson::CtFrame>& p);
  void left_view();
  /// While the left button has no other meaning.
  void double_clicked();
  /// A right click that did not drag, on the screen.
  void menu_wanted(const QPoint& place);
  /// Another slice, or how it is drawn; not where only its labels are others.
  void slice_changed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void refresh_slice();
  void refresh_overlays();
  void show_hand();
  void step(int slices);
  /// Metres from a slice to the next.
  double step_length() const;
  bool has_tool() const { return state_.is_measuring() || state_.hand() != Hand::crosshair; }
  QTransform widget_from_pixel() const;
  Point<CtFrame> p_in_ct(const QPointF& widget) const;
  double metres_per_pixel() const;  ///< of the widget
  void begin_gesture(const QMouseEvent& event);
  void tell(SliceGesture::Phase phase, const QMouseEvent& event);
  /// Brings what is shown up to date with the slice's picture, in these pixels of it.
  void redraw(const QRect& pixels);
  void paint_overlay(QPainter& painter);
  void paint_marks(QPainter& painter) const;
  /// Where a point (CT frame) lies close to the slice, paler with its distance.
  void paint_disc(QPainter& painter, const Eigen::Vector3d& p, QColor colour) const;
  void paint_brush(QPainter& painter) const;
  void paint_line(QPainter& painter) const;
  void paint_measures(QPainter& painter) const;

  ViewState& state_;
  scene::Plane plane_;
  scene::SliceGeometry slice_;
  scene::SliceDrawing drawing_;
  QImage image_;    ///< the slice, a view of the drawing's picture
  QImage shown_;    ///< the same as large as the widget; null: to be made again
  QImage overlay_;  ///< preview or evolving outline
  bool overlay_is_stale_ = true;
  QTimer* flash_ = nullptr;
  bool bright_ = true;
  bool dragging_ = false;
  QPolygonF lasso_;  ///< pixels of the slice
  double zoom_ = 1.0;
  QPointF pan_;
  QPointF pressed_, last_;
  bool moved_ = false;  ///< since the press, by more than a hand trembles
  double wheel_rest_ = 0.0;
};

}  // namespace glisson::ui
