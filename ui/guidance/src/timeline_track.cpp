// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/timeline_track.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace glisson::ui {
namespace {

constexpr double kMargin = 8.0, kBar = 8.0;

/// Okabe and Ito's: told apart by colour-blind readers, and by their luminance.
QColor colour_of(Level level) {
  switch (level) {
    case Level::valid:
      return {0, 114, 178};
    case Level::degraded:
      return {230, 159, 0};
    case Level::withdrawn:
      return {213, 94, 0};
  }
  return {};
}

}  // namespace

TimelineTrack::TimelineTrack(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Timeline"));
  setToolTip(tr("Blue: overlay shown. Yellow: outline and regions only. Red: no overlay."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void TimelineTrack::set_range(int first, int last) {
  first_ = first;
  last_ = std::max(first, last);
  update();
}

void TimelineTrack::set_position(int index) {
  position_ = index;
  update();
}

void TimelineTrack::set_marks(const std::vector<LevelMark>& marks) {
  marks_ = marks;
  update();
}

double TimelineTrack::place_of(int index) const {
  const double share = last_ > first_ ? static_cast<double>(index - first_) / (last_ - first_) : 0.0;
  return kMargin + std::clamp(share, 0.0, 1.0) * (width() - 2.0 * kMargin);
}

void TimelineTrack::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const double top = 0.5 * (height() - kBar);
  painter.setBrush(QColor(58, 70, 79));
  painter.drawRoundedRect(QRectF(kMargin, top, width() - 2.0 * kMargin, kBar), 2.0, 2.0);
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const double from = place_of(marks_[i].index);
    const double to = i + 1 < marks_.size() ? place_of(marks_[i + 1].index) : place_of(last_);
    painter.setBrush(colour_of(marks_[i].level));
    painter.drawRect(QRectF(from, top, std::max(1.0, to - from), kBar));
  }
  painter.setPen(QPen(QColor(240, 240, 240), 1.0));
  for (std::size_t i = 1; i < marks_.size(); ++i) {
    const double at = place_of(marks_[i].index);
    painter.drawLine(QPointF(at, top - 4.0), QPointF(at, top + kBar + 4.0));
  }
  const QPointF here(place_of(position_), 0.5 * height());
  painter.setPen(QPen(QColor(12, 16, 20), 1.5));
  painter.setBrush(QColor(255, 255, 255));
  painter.drawEllipse(here, 6.0, 6.0);
}

void TimelineTrack::ask_for(double x) {
  const double share = (x - kMargin) / std::max(1.0, width() - 2.0 * kMargin);
  emit wanted(first_ + static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * (last_ - first_))));
}

void TimelineTrack::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) ask_for(event->position().x());
}

void TimelineTrack::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) ask_for(event->position().x());
}

}  // namespace glisson::ui
