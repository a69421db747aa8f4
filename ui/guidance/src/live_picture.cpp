// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/live_picture.h"

#include <QMouseEvent>
#include <QWheelEvent>

namespace glisson::ui {

LivePicture::LivePicture(QWidget* parent) : PictureView({}, parent) { setFocusPolicy(Qt::StrongFocus); }

bool LivePicture::holds(const QPointF& widget) const {
  if (picture().empty()) return false;
  const Eigen::Vector2d pixel = pixel_at(widget);
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < picture().width - 0.5 &&
         pixel.y() < picture().height - 0.5;
}

void LivePicture::mousePressEvent(QMouseEvent* event) {
  PictureView::mousePressEvent(event);
  if (!holds(event->position())) return;
  const Eigen::Vector2d pixel = pixel_at(event->position());
  if (placing_) {
    if (event->button() == Qt::LeftButton) grabbed_ = pixel;
    return;
  }
  const bool with_control = event->modifiers().testFlag(Qt::ControlModifier);
  if (event->button() == Qt::RightButton || (event->button() == Qt::LeftButton && with_control))
    emit marked(pixel);
  else if (event->button() == Qt::LeftButton)
    emit clicked(pixel);
}

void LivePicture::set_placing(bool on) {
  placing_ = on;
  grabbed_.reset();
  setCursor(on ? Qt::OpenHandCursor : Qt::ArrowCursor);
}

void LivePicture::mouseReleaseEvent(QMouseEvent* event) {
  PictureView::mouseReleaseEvent(event);
  grabbed_.reset();
}

void LivePicture::wheelEvent(QWheelEvent* event) {
  if (!placing_) return PictureView::wheelEvent(event);
  constexpr double kNotch = 120.0;
  emit wheeled(event->angleDelta().y() / kNotch);
  event->accept();
}

void LivePicture::mouseMoveEvent(QMouseEvent* event) {
  PictureView::mouseMoveEvent(event);
  if (placing_) {
    if (!grabbed_) return;
    const Eigen::Vector2d pixel = pixel_at(event->position());
    emit dragged(*grabbed_, pixel, event->modifiers());
    grabbed_ = pixel;
    return;
  }
  if (holds(event->position()))
    emit pointed(pixel_at(event->position()));
  else
    emit left();
}

void LivePicture::leaveEvent(QEvent* event) {
  PictureView::leaveEvent(event);
  emit left();
}

}  // namespace glisson::ui
