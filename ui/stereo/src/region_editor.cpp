// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/region_editor.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "glisson/ui/scene/colours.h"

namespace glisson::ui {
namespace {

using scene::colour_of;

constexpr double kReach = 9.0;  ///< pixels on the screen within which a corner is taken

bool close_to(const QPointF& a, const QPointF& b) {
  const QPointF d = a - b;
  return d.x() * d.x() + d.y() * d.y() <= kReach * kReach;
}

}  // namespace

RegionEditor::RegionEditor(QWidget* parent) : PictureView(tr("Left"), parent) {
  setFocusPolicy(Qt::StrongFocus);
  set_hint(tr("Load a stereo pair or a video, and the laparoscope's calibration."));
}

void RegionEditor::set_feature(std::optional<Feature> feature) {
  feature_ = feature;
  open_.clear();
  setCursor(feature ? Qt::CrossCursor : Qt::ArrowCursor);
  if (feature) setFocus();
  update();
}

void RegionEditor::set_regions(const std::vector<stereo::Region>& regions) {
  regions_ = regions;
  dragged_.reset();
  update();
}

void RegionEditor::set_dots(std::vector<Eigen::Vector2d> dots, std::vector<Feature> features) {
  dots_ = std::move(dots);
  dot_features_ = std::move(features);
  update();
}

QPolygonF RegionEditor::on_screen(const std::vector<Eigen::Vector2d>& polygon) const {
  QPolygonF shape;
  for (const Eigen::Vector2d& p : polygon) shape << widget_point(p);
  return shape;
}

Eigen::Vector2d RegionEditor::pixel_inside(const QPointF& place) const {
  return pixel_at(place)
      .cwiseMax(Eigen::Vector2d::Zero())
      .cwiseMin(Eigen::Vector2d(picture().width - 1, picture().height - 1));
}

std::optional<RegionEditor::Corner> RegionEditor::corner_at(const QPointF& place) const {
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (std::size_t c = 0; c < regions_[r].polygon.size(); ++c)
      if (close_to(widget_point(regions_[r].polygon[c]), place)) return Corner{r, c};
  return std::nullopt;
}

void RegionEditor::remove_region_at(const QPointF& place) {
  for (std::size_t r = regions_.size(); r-- > 0;)
    if (on_screen(regions_[r].polygon).containsPoint(place, Qt::OddEvenFill)) {
      regions_.erase(regions_.begin() + static_cast<std::ptrdiff_t>(r));
      update();
      emit regions_edited();
      return;
    }
}

void RegionEditor::add_corner(const QPointF& place) {
  if (open_.size() >= 3 && close_to(widget_point(open_.front()), place)) return close_region();
  open_.push_back(pixel_inside(place));
  update();
}

void RegionEditor::close_region() {
  if (open_.size() < 3) return;
  regions_.push_back({*feature_, open_});
  open_.clear();
  update();
  emit regions_edited();
}

void RegionEditor::mousePressEvent(QMouseEvent* event) {
  if (picture().empty()) return;
  pointer_ = event->position();
  if (event->button() == Qt::RightButton && open_.empty()) return remove_region_at(event->position());
  if (event->button() != Qt::LeftButton) return;
  // Regions touch one another: whoever draws one does not want to move its neighbour's corners.
  if (feature_)
    add_corner(event->position());
  else
    dragged_ = corner_at(event->position());
}

void RegionEditor::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  if (dragged_) regions_[dragged_->region].polygon[dragged_->corner] = pixel_inside(event->position());
  if (dragged_ || !open_.empty()) update();
}

void RegionEditor::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !dragged_) return;
  dragged_.reset();
  emit regions_edited();
}

void RegionEditor::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Backspace && !open_.empty()) {
    open_.pop_back();
    update();
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    close_region();
  } else if (event->key() == Qt::Key_Escape) {
    set_feature(std::nullopt);
    emit drawing_ended();
  } else {
    PictureView::keyPressEvent(event);
  }
}

void RegionEditor::paint_over(QPainter& painter) {
  painter.setPen(Qt::NoPen);
  for (std::size_t i = 0; i < dots_.size(); ++i) {
    QColor colour = colour_of(i < dot_features_.size() ? dot_features_[i] : Feature::surface);
    colour.setAlpha(200);
    painter.setBrush(colour);
    painter.drawEllipse(widget_point(dots_[i]), 1.6, 1.6);
  }
  for (const stereo::Region& region : regions_) {
    const QColor colour = colour_of(region.feature);
    QColor fill = colour;
    fill.setAlpha(38);
    const QPolygonF shape = on_screen(region.polygon);
    painter.setPen(QPen(colour, 2.0));
    painter.setBrush(fill);
    painter.drawPolygon(shape);
    painter.setBrush(QColor(20, 24, 28));
    for (const QPointF& corner : shape) painter.drawEllipse(corner, 3.5, 3.5);
  }
  if (open_.empty() || !feature_) return;
  const QPolygonF shape = on_screen(open_);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour_of(*feature_), 2.0, Qt::DashLine));
  painter.drawPolyline(shape);
  painter.drawLine(shape.back(), pointer_);
  painter.setPen(QPen(colour_of(*feature_), 2.0));
  const bool closes = open_.size() >= 3 && close_to(shape.front(), pointer_);
  painter.setBrush(closes ? QBrush(colour_of(*feature_)) : QBrush(QColor(20, 24, 28)));
  painter.drawEllipse(shape.front(), closes ? 6.0 : 4.5, closes ? 6.0 : 4.5);
}

}  // namespace glisson::ui
