// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/surface_drag.h"

#include <QMouseEvent>
#include <cmath>

namespace glisson::ui {
namespace {

constexpr double kReach = 12.0;  // pixels from a handle

}  // namespace

SurfaceDrag::SurfaceDrag(LinkedViews& views, QObject* parent) : QObject(parent), views_(views) {}

void SurfaceDrag::set_on(bool on) {
  if (on == on_) return;
  on_ = on;
  dragging_ = false;
  RenderView& view = views_.volume();
  view.set_taken(this, on);
  view.setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
  view.setMouseTracking(on);
  if (on)
    view.installEventFilter(this);
  else
    view.removeEventFilter(this);
  if (!on) emit left();
}

std::optional<Eigen::Vector3d> SurfaceDrag::place(const QPointF& at) const {
  const RenderView& view = views_.volume();
  return views_.surface_point(at.x() / std::max(1, view.width()), at.y() / std::max(1, view.height()));
}

std::optional<Eigen::Vector3d> SurfaceDrag::handle_at(const QPointF& at) const {
  RenderView& view = views_.volume();
  std::optional<Eigen::Vector3d> best;
  double least = kReach;
  for (Eigen::Index k = 0; k < handles_.rows(); ++k) {
    const Eigen::Vector3d p = handles_.row(k).transpose();
    const auto seen = view.patient().view_point(p, view.aspect());
    if (!seen) continue;
    const double away = std::hypot(seen->x() * view.width() - at.x(), seen->y() * view.height() - at.y());
    if (away >= least) continue;
    least = away;
    best = p;
  }
  return best;
}

std::optional<Eigen::Vector3d> SurfaceDrag::dragged_to(const QPointF& at) {
  auto p = place(at);
  RenderView& view = views_.volume();
  if (!p && handles_.rows() > 0)
    p = view.patient().point_beside(last_, at.x() / std::max(1, view.width()),
                                    at.y() / std::max(1, view.height()), view.aspect());
  if (!p || !p->allFinite()) return {};
  last_ = *p;
  return p;
}

void SurfaceDrag::tell_hover(const QPointF& at) {
  if (const auto p = place(at))
    emit hovered(*p);
  else
    emit left();
}

bool SurfaceDrag::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &views_.volume() && event->type() == QEvent::Leave && !dragging_) emit left();
  const auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (watched != &views_.volume() || mouse == nullptr) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
      if (dragging_) return true;  // the camera keeps still meanwhile
      if (mouse->button() != Qt::LeftButton) return false;
      auto p = place(mouse->position());
      if (!p) p = handle_at(mouse->position());
      if (!p) return false;
      last_ = *p;
      dragging_ = true;
      emit began(*p, mouse->modifiers());
      return true;
    }
    case QEvent::MouseMove:
      if (!dragging_ && mouse->buttons() == Qt::NoButton) {
        tell_hover(mouse->position());
        return true;  // the camera is turned by drags alone
      }
      if (!dragging_) return false;
      if (const auto p = dragged_to(mouse->position())) emit moved(*p, mouse->modifiers());
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
