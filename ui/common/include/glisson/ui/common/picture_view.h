// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QPointF>
#include <QWidget>

#include "glisson/patient/picture.h"

namespace glisson::ui {

/// A picture, as large as it fits, with its title. Pixel coordinates are OpenCV's: whole numbers are centres.
class PictureView : public QWidget {
  Q_OBJECT
 public:
  explicit PictureView(const QString& title, QWidget* parent = nullptr);

  /// @param ready the same as the screen takes it (scene::screen_image()), of screen_size(): shown as it is,
  /// so
  ///   that nothing is scaled on the window's thread. Null, or of another size: the picture is scaled.
  void set_picture(const Picture& picture, const QImage& ready = {});
  const Picture& picture() const { return picture_; }
  /// Of a picture of `size` as large as it fits here, in the screen's pixels.
  QSize screen_size(const QSize& size) const;
  /// Shown while there is no picture.
  void set_hint(const QString& hint);
  /// Whether the wheel enlarges it about the pointer (up to 16 times), and the middle button moves it.
  void set_zoomable(bool zoomable) { zoomable_ = zoomable; }
  QPointF widget_point(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d pixel_at(const QPointF& widget) const;
  QSize sizeHint() const override { return {480, 270}; }
  QSize minimumSizeHint() const override { return {160, 90}; }

 signals:
  /// The same pixels are elsewhere now.
  void zoomed();
  /// The picture has been painted.
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  /// The picture alone, where it lies in the widget. @pre there is one.
  void draw_picture(QPainter& painter) const;
  /// Draws on top of the picture, in widget coordinates.
  virtual void paint_over(QPainter& painter);

 private:
  QRectF picture_area() const;
  void paint(QPainter& painter);
  /// Shows `pixel` at a place of the widget, as far as the picture still fills it.
  void place(const Eigen::Vector2d& pixel, const QPointF& widget);

  Picture picture_;
  QImage image_;
  QImage ready_;  ///< the same for the screen; null: there is none
  QString title_, hint_;
  bool zoomable_ = false;
  double zoom_ = 1.0;  ///< 1: as large as it fits
  QPointF moved_;      ///< of the enlarged picture's middle from the widget's
  QPointF pressed_;    ///< where the middle button was last
};

}  // namespace glisson::ui
