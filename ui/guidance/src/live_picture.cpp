// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/live_picture.h"

#include <QFontInfo>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

namespace glisson::ui {

LivePicture::LivePicture(const QString& title, QWidget* parent) : PictureView(title, parent) {
  setFocusPolicy(Qt::StrongFocus);
}

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
  const bool takes_hold = correcting_ || event->modifiers().testFlag(Qt::ShiftModifier);
  if (event->button() == Qt::LeftButton && takes_hold) {
    holding_ = true;
    emit taken_hold(pixel);
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
  show_cursor();
}

void LivePicture::set_correcting(bool on) {
  correcting_ = on;
  show_cursor();
}

void LivePicture::show_cursor() {
  setCursor(placing_ ? Qt::OpenHandCursor : correcting_ ? Qt::CrossCursor : Qt::ArrowCursor);
}

void LivePicture::set_drag_line(const std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& line) {
  drag_line_ = line;
  update();
}

void LivePicture::set_mark(const QString& words) {
  mark_ = words;
  update();
}

void LivePicture::paint_over(QPainter& painter) {
  if (!mark_.isEmpty()) {
    QFont font = painter.font();
    font.setPixelSize(qRound(1.3 * QFontInfo(font).pixelSize()));
    font.setBold(true);
    painter.setFont(font);
    QRectF box = painter.fontMetrics().boundingRect(mark_).adjusted(-12, -6, 12, 6);
    box.moveCenter(QPointF(0.5 * width(), 0.0));
    box.moveTop(10.0);
    painter.setPen(QPen(QColor(255, 207, 112), 2.0));  // as warnings are
    painter.setBrush(QColor(12, 16, 20, 230));
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.drawText(box, Qt::AlignCenter, mark_);
  }
  if (!drag_line_) return;
  const QPointF from = widget_point(drag_line_->first), to = widget_point(drag_line_->second);
  // Dark below light: seen on any tissue.
  for (const auto& [colour, width] : {std::pair{QColor(12, 16, 20), 5.0}, {QColor(240, 228, 66), 2.0}}) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(from, to);
    painter.drawEllipse(from, 4.0, 4.0);
    painter.drawLine(to - QPointF(7.0, 0.0), to + QPointF(7.0, 0.0));
    painter.drawLine(to - QPointF(0.0, 7.0), to + QPointF(0.0, 7.0));
  }
}

void LivePicture::mouseReleaseEvent(QMouseEvent* event) {
  PictureView::mouseReleaseEvent(event);
  grabbed_.reset();
  if (holding_ && event->button() == Qt::LeftButton) {
    holding_ = false;
    if (!picture().empty()) emit let_go(pixel_at(event->position()));
  }
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
  if (holding_) emit held_at(pixel_at(event->position()));
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
