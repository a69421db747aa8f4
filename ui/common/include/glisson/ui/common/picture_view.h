// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QWidget>

#include "glisson/patient/picture.h"

namespace glisson::ui {

/// A picture, as large as it fits, with its title. Pixel coordinates are OpenCV's: whole numbers are centres.
class PictureView : public QWidget {
  Q_OBJECT
 public:
  explicit PictureView(const QString& title, QWidget* parent = nullptr);

  void set_picture(const Picture& picture);
  const Picture& picture() const { return picture_; }
  /// Shown while there is no picture.
  void set_hint(const QString& hint);
  QPointF widget_point(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d pixel_at(const QPointF& widget) const;
  QSize sizeHint() const override { return {480, 270}; }
  QSize minimumSizeHint() const override { return {160, 90}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  /// The picture alone, where it lies in the widget. @pre there is one.
  void draw_picture(QPainter& painter) const;
  /// Draws on top of the picture, in widget coordinates.
  virtual void paint_over(QPainter& painter);

 private:
  QRectF picture_area() const;

  Picture picture_;
  QImage image_;
  QString title_, hint_;
};

}  // namespace glisson::ui
