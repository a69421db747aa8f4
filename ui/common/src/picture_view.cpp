// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/picture_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "glisson/ui/scene/picture_image.h"

namespace glisson::ui {

PictureView::PictureView(const QString& title, QWidget* parent) : QWidget(parent), title_(title) {
  setMouseTracking(true);
}

void PictureView::set_picture(const Picture& picture, const QImage& ready) {
  if (picture.width != picture_.width || picture.height != picture_.height) {
    zoom_ = 1.0;
    moved_ = {};
  }
  picture_ = picture;
  image_ = scene::view_as_image(picture_);
  ready_ = ready;
  update();
}

QSize PictureView::screen_size(const QSize& size) const {
  return (QSizeF(size.scaled(this->size(), Qt::KeepAspectRatio)) * devicePixelRatioF()).toSize();
}

void PictureView::set_hint(const QString& hint) {
  hint_ = hint;
  update();
}

QRectF PictureView::picture_area() const {
  if (picture_.empty()) return {};
  const double scale = zoom_ * std::min(static_cast<double>(width()) / picture_.width,
                                        static_cast<double>(height()) / picture_.height);
  const QSizeF size(scale * picture_.width, scale * picture_.height);
  // Where the widget has become larger than the picture, that stays in the middle.
  const double most_x = std::max(0.0, 0.5 * (size.width() - width()));
  const double most_y = std::max(0.0, 0.5 * (size.height() - height()));
  const QPointF moved(std::clamp(moved_.x(), -most_x, most_x), std::clamp(moved_.y(), -most_y, most_y));
  return {moved + QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size};
}

QPointF PictureView::widget_point(const Eigen::Vector2d& pixel) const {
  const QRectF area = picture_area();
  return {area.left() + (pixel.x() + 0.5) / picture_.width * area.width(),
          area.top() + (pixel.y() + 0.5) / picture_.height * area.height()};
}

Eigen::Vector2d PictureView::pixel_at(const QPointF& widget) const {
  const QRectF area = picture_area();
  return {(widget.x() - area.left()) / area.width() * picture_.width - 0.5,
          (widget.y() - area.top()) / area.height() * picture_.height - 0.5};
}

void PictureView::place(const Eigen::Vector2d& pixel, const QPointF& widget) {
  moved_ += widget - widget_point(pixel);
  moved_ = picture_area().center() - QRectF(rect()).center();  // no further than it goes
  update();
  emit zoomed();
}

void PictureView::wheelEvent(QWheelEvent* event) {
  if (!zoomable_ || picture_.empty()) return QWidget::wheelEvent(event);
  constexpr double kStep = 1.25, kNotch = 120.0, kMost = 16.0;
  const Eigen::Vector2d pixel = pixel_at(event->position());
  zoom_ = std::clamp(zoom_ * std::pow(kStep, event->angleDelta().y() / kNotch), 1.0, kMost);
  moved_ = picture_area().center() - QRectF(rect()).center();
  place(pixel, event->position());
  event->accept();
}

void PictureView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) pressed_ = event->position();
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
  if (!zoomable_ || picture_.empty() || !(event->buttons() & Qt::MiddleButton)) return;
  place(pixel_at(pressed_), event->position());
  pressed_ = event->position();
}

void PictureView::paintEvent(QPaintEvent*) {
  {
    QPainter painter(this);
    paint(painter);
  }
  if (!image_.isNull()) emit drawn();
}

void PictureView::paint(QPainter& painter) {
  painter.fillRect(rect(), QColor(0, 0, 0));
  if (image_.isNull()) {
    painter.setPen(QColor(140, 150, 158));
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, hint_);
  } else {
    painter.setRenderHints(QPainter::SmoothPixmapTransform | QPainter::Antialiasing);
    draw_picture(painter);
    paint_over(painter);
  }
  if (title_.isEmpty()) return;
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  const QRect box = painter.fontMetrics().boundingRect(title_).adjusted(-6, -2, 6, 2);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(12, 16, 20, 170));
  const QRect plate(QPoint(6, 6), box.size());
  painter.drawRoundedRect(plate, 3, 3);
  painter.setPen(QColor(225, 230, 233));
  painter.drawText(plate, Qt::AlignCenter, title_);
}

void PictureView::draw_picture(QPainter& painter) const {
  const bool fits =
      zoom_ == 1.0 && !ready_.isNull() && ready_.size() == screen_size({picture_.width, picture_.height});
  if (!fits) return painter.drawImage(picture_area(), image_);
  QImage image = ready_;
  image.setDevicePixelRatio(devicePixelRatioF());
  painter.drawImage(picture_area().topLeft().toPoint(), image);  // between pixels it would be scaled again
}

void PictureView::paint_over(QPainter&) {}

}  // namespace glisson::ui
