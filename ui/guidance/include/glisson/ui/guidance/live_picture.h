// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "glisson/ui/common/picture_view.h"

namespace glisson::ui {

/// The augmented picture, which tells where a person points and clicks, in its pixels.
class LivePicture : public PictureView {
  Q_OBJECT
 public:
  explicit LivePicture(QWidget* parent = nullptr);
  /// From now on drags and the wheel move the organ instead of pointing at it.
  void set_placing(bool on);

 signals:
  void clicked(const Eigen::Vector2d& pixel);
  /// With the right button, or with Ctrl.
  void marked(const Eigen::Vector2d& pixel);
  void pointed(const Eigen::Vector2d& pixel);
  /// The pointer has left the picture.
  void left();
  /// While the organ is placed: the left button went from one pixel to the next, with these keys.
  void dragged(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Qt::KeyboardModifiers keys);
  /// Notches of the wheel, away from the hand positive.
  void wheeled(double notches);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// Whether a place of the widget lies on the picture.
  bool holds(const QPointF& widget) const;

  bool placing_ = false;
  std::optional<Eigen::Vector2d> grabbed_;  ///< where the drag was last
};

}  // namespace glisson::ui
