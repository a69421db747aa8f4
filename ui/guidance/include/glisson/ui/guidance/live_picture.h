// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

#include "glisson/ui/common/picture_view.h"

namespace glisson::ui {

/// The augmented picture, which tells where a person points and clicks, in its pixels.
class LivePicture : public PictureView {
  Q_OBJECT
 public:
  /// @param title in its corner; empty: none
  explicit LivePicture(const QString& title = {}, QWidget* parent = nullptr);
  /// From now on drags and the wheel move the organ instead of pointing at it.
  void set_placing(bool on);
  /// From now on drags take hold of a place of the organ. With Shift they always do.
  void set_correcting(bool on);
  /// Drawn over the picture, pixels: from where a place was drawn to where a hand holds it; empty: nothing.
  void set_drag_line(const std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& line);
  /// Words in a box at the top of the picture; empty: none.
  void set_mark(const QString& words);

 signals:
  void clicked(const Eigen::Vector2d& pixel);
  /// With the right button, or with Ctrl.
  void marked(const Eigen::Vector2d& pixel);
  void pointed(const Eigen::Vector2d& pixel);
  /// The pointer has left the picture.
  void left();
  /// While the organ is placed: the left button went from one pixel to the next, with these keys.
  void dragged(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Qt::KeyboardModifiers keys);
  /// A place of the organ: a hand takes hold of it, drags it, lets go.
  void taken_hold(const Eigen::Vector2d& pixel);
  void held_at(const Eigen::Vector2d& pixel);
  void let_go(const Eigen::Vector2d& pixel);
  /// Notches of the wheel, away from the hand positive.
  void wheeled(double notches);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void paint_over(QPainter& painter) override;

 private:
  /// Whether a place of the widget lies on the picture.
  bool holds(const QPointF& widget) const;

  void show_cursor();

  bool placing_ = false, correcting_ = false;
  bool holding_ = false;  ///< a place of the organ
  std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> drag_line_;
  QString mark_;
  std::optional<Eigen::Vector2d> grabbed_;  ///< where the drag was last
};

}  // namespace glisson::ui
