// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/surface_drag.h"

#include <QMouseEvent>

namespace glisson::ui {

SurfaceDrag::SurfaceDrag(LinkedViews& views, QObject* parent) : QObject(parent), views_(views) {}

void SurfaceDrag::set_on(bool on) {
  if (on == on_) return;
  on_ = on;
  dragging_ = false;
  RenderView& view = views_.volume();
  view.setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
  if (on)
    view.installEventFilter(this);
  else
    view.removeEventFilter(this);
}

std::optional<Eigen::Vector3d> SurfaceDrag::place(const QPointF& at) const {
  const RenderView& view = views_.volume();
  return views_.surface_point(at.x() / std::max(1, view.width()), at.y() / std::max(1, view.height()));
}

bool SurfaceDrag::eventFilter(QObject* watched, QEvent* event) {
  const auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (watched != &views_.volume() || mouse == nullptr) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
      if (dragging_) return true;  // the camera keeps still meanwhile
      if (mouse->button() != Qt::LeftButton) return false;
      const auto p = place(mouse->position());
      if (!p) return false;
      dragging_ = true;
      emit began(*p, mouse->modifiers());
      return true;
    }
    case QEvent::MouseMove:
      if (!dragging_) return false;
      if (const auto p = place(mouse->position())) emit moved(*p, mouse->modifiers());
      return true;
    case QEvent::MouseButtonRelease:
      if (!dragging_) return false;
      if (mouse->button() != Qt::LeftButton) return true;
      dragging_ = false;
      emit ended();
      return true;
    default:
      return false;
  }
}

}  // namespace glisson::ui
