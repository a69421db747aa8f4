// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QObject>

#include "glisson/ui/common/linked_views.h"

namespace glisson::ui {

/// Presses on the liver in the 3D view and what is dragged over it from there, while it is on. Beside the
/// liver the mouse turns the view as always.
class SurfaceDrag : public QObject {
  Q_OBJECT
 public:
  SurfaceDrag(LinkedViews& views, QObject* parent);

  void set_on(bool on);
  /// Points that can be taken from beside the liver, too, where its edge hides them (CT frame, metres); with
  /// any, a drag goes on beside the liver, as deep in the view as it was last.
  void set_handles(const Points& handles) { handles_ = handles; }
  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  /// A place on the liver, CT frame, metres.
  void began(const Eigen::Vector3d& p, Qt::KeyboardModifiers keys);
  /// Without handles told only where the pointer is over the liver.
  void moved(const Eigen::Vector3d& p, Qt::KeyboardModifiers keys);
  void ended();
  /// The pointer is over this place of the liver and nothing is pressed.
  void hovered(const Eigen::Vector3d& p);
  /// It is beside the liver, or elsewhere.
  void left();

 private:
  /// In the CT frame, here and below.
  std::optional<Eigen::Vector3d> place(const QPointF& at) const;
  void tell_hover(const QPointF& at);
  std::optional<Eigen::Vector3d> handle_at(const QPointF& at) const;
  /// While it is dragged.
  std::optional<Eigen::Vector3d> dragged_to(const QPointF& at);

  LinkedViews& views_;
  Points handles_{0, 3};
  Eigen::Vector3d last_ = Eigen::Vector3d::Zero();
  bool on_ = false, dragging_ = false;
};

}  // namespace glisson::ui
