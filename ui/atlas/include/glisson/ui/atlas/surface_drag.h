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
  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  /// A place on the liver, CT frame, metres.
  void began(const Eigen::Vector3d& p, Qt::KeyboardModifiers keys);
  /// Told only where the pointer is over the liver.
  void moved(const Eigen::Vector3d& p, Qt::KeyboardModifiers keys);
  void ended();

 private:
  std::optional<Eigen::Vector3d> place(const QPointF& at) const;

  LinkedViews& views_;
  bool on_ = false, dragging_ = false;
};

}  // namespace glisson::ui
