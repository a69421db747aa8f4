// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "glisson/ui/common/picture_view.h"

namespace glisson::ui {

/// The augmented picture, which tells where a person points and clicks, in its pixels.
class LivePicture : public PictureView {
  Q_OBJECT
 public:
  explicit LivePicture(QWidget* parent = nullptr);

 signals:
  void clicked(const Eigen::Vector2d& pixel);
  /// With the right button, or with Ctrl.
  void marked(const Eigen::Vector2d& pixel);
  void pointed(const Eigen::Vector2d& pixel);
  /// The pointer has left the picture.
  void left();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// Whether a place of the widget lies on the picture.
  bool holds(const QPointF& widget) const;
};

}  // namespace glisson::ui
