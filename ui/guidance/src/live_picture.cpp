// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/live_picture.h"

#include <QMouseEvent>

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
  const bool with_control = event->modifiers().testFlag(Qt::ControlModifier);
  if (event->button() == Qt::RightButton || (event->button() == Qt::LeftButton && with_control))
    emit marked(pixel);
  else if (event->button() == Qt::LeftButton)
    emit clicked(pixel);
}

void LivePicture::mouseMoveEvent(QMouseEvent* event) {
  PictureView::mouseMoveEvent(event);
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
