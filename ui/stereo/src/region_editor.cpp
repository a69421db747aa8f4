// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/region_editor.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "glisson/ui/scene/colours.h"

namespace glisson::ui {
namespace {

using scene::colour_of;
using Click = RegionDrawing::Click;

constexpr double kReach = 9.0;           ///< pixels on the screen within which a corner is taken
constexpr double kLoupeRadius = 58.0;    ///< pixels on the screen
constexpr double kLoupeDistance = 84.0;  ///< of its middle from the pointer
constexpr double kLoupeScale = 3.0;      ///< times what is on the screen
const QColor kDark(20, 24, 28);
const QColor kGuide(255, 209, 64);

Qt::CursorShape cursor_of(Click click) {
  switch (click) {
    case Click::begin:
    case Click::add:
      return Qt::CrossCursor;
    case Click::close:
    case Click::end_curve:
    case Click::select:
      return Qt::PointingHandCursor;
    case Click::wrong_picture:
      return Qt::ForbiddenCursor;
    case Click::drag:
      return Qt::SizeAllCursor;
    case Click::insert:
      return Qt::DragCopyCursor;
    case Click::nothing:
      return Qt::ArrowCursor;
  }
  return Qt::ArrowCursor;
}

}  // namespace

RegionEditor::RegionEditor(stereo::Side side, const QString& title, RegionDrawing& drawing, QWidget* parent)
    : PictureView(title, parent), side_(side), drawing_(drawing) {
  setFocusPolicy(Qt::StrongFocus);
  set_zoomable(true);
  setAccessibleName(title);
}

void RegionEditor::set_dots(std::vector<Eigen::Vector2d> dots, std::vector<Feature> features) {
  dots_ = std::move(dots);
  dot_features_ = std::move(features);
  update();
}

void RegionEditor::set_guide(std::vector<Eigen::Vector2d> line, const std::optional<Eigen::Vector2d>& point) {
  guide_ = std::move(line);
  guide_point_ = point;
  update();
}

void RegionEditor::set_veil(const QImage& veil) {
  veil_ = veil;
  update();
}

void RegionEditor::set_loupe(bool on) {
  loupe_ = on;
  update();
}

QPolygonF RegionEditor::on_screen(const std::vector<Eigen::Vector2d>& polygon) const {
  QPolygonF shape;
  for (const Eigen::Vector2d& p : polygon) shape << widget_point(p);
  return shape;
}

double RegionEditor::pixels_on_screen() const {
  return widget_point({1.0, 0.0}).x() - widget_point({0.0, 0.0}).x();
}

RegionDrawing::Place RegionEditor::place_at(const QPointF& widget) const {
  const Eigen::Vector2d pixel = pixel_at(widget)
                                    .cwiseMax(Eigen::Vector2d::Zero())
                                    .cwiseMin(Eigen::Vector2d(picture().width - 1, picture().height - 1));
  return {side_, pixel, kReach / pixels_on_screen()};
}

void RegionEditor::update_cursor() {
  setCursor(picture().empty() || !pointer_ ? Qt::ArrowCursor
                                           : cursor_of(drawing_.click_at(place_at(*pointer_))));
}

void RegionEditor::tell(bool edited) {
  update_cursor();
  emit drawing_changed();
  if (edited) emit regions_edited();
}

void RegionEditor::mousePressEvent(QMouseEvent* event) {
  PictureView::mousePressEvent(event);
  if (picture().empty()) return;
  pointer_ = event->position();
  const RegionDrawing::Place place = place_at(event->position());
  if (event->button() == Qt::RightButton) return tell(drawing_.remove_at(place));
  if (event->button() != Qt::LeftButton) return;
  if (!drawing_.tool()) emit pointed();
  tell(drawing_.press(place));
}

void RegionEditor::mouseDoubleClickEvent(QMouseEvent* event) {
  if (picture().empty() || event->button() != Qt::LeftButton) return;
  tell(drawing_.double_click(place_at(event->position())));
}

void RegionEditor::mouseMoveEvent(QMouseEvent* event) {
  PictureView::mouseMoveEvent(event);
  if (picture().empty()) return;
  pointer_ = event->position();
  drawing_.move(place_at(event->position()));
  update_cursor();
  update();
  emit pointer_moved();
}

void RegionEditor::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && drawing_.dragged()) tell(drawing_.release());
}

void RegionEditor::leaveEvent(QEvent* event) {
  pointer_.reset();
  update();
  emit pointer_moved();
  PictureView::leaveEvent(event);
}

void RegionEditor::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Undo)) return tell(drawing_.undo());
  // On Linux Qt knows Ctrl+Shift+Z only.
  const bool ctrl_y = event->key() == Qt::Key_Y && event->modifiers() == Qt::ControlModifier;
  if (ctrl_y || event->matches(QKeySequence::Redo)) return tell(drawing_.redo());
  switch (event->key()) {
    case Qt::Key_Backspace:
      drawing_.take_back();
      return tell(false);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return tell(drawing_.finish());
    case Qt::Key_Delete:
      return tell(drawing_.remove_selected());
    case Qt::Key_Escape:
      drawing_.drop();
      return tell(false);
    default:
      PictureView::keyPressEvent(event);
  }
}

void RegionEditor::paint_region(QPainter& painter, const stereo::Region& region, bool finished, bool selected,
                                double scale) const {
  const QColor colour = colour_of(region.feature);
  QColor fill = colour;
  fill.setAlpha(selected ? 70 : 38);
  const QPolygonF shape = on_screen(region.polygon);
  painter.setBrush(Qt::NoBrush);
  if (!region.closed) {
    painter.setPen(QPen(fill, 2.0 * region.half_width_px * pixels_on_screen(), Qt::SolidLine, Qt::RoundCap,
                        Qt::RoundJoin));
    painter.drawPolyline(shape);
  }
  painter.setPen(QPen(colour, (selected ? 3.0 : 2.0) / scale, finished ? Qt::SolidLine : Qt::DashLine));
  if (region.closed && finished) {
    painter.setBrush(fill);
    painter.drawPolygon(shape);
  } else {
    painter.drawPolyline(shape);
  }
  painter.setPen(QPen(colour, 1.5 / scale));
  painter.setBrush(kDark);
  for (const QPointF& corner : shape) painter.drawEllipse(corner, 3.5 / scale, 3.5 / scale);
}

/// Everything over the picture. @param scale by which the painter enlarges: lines stay as thin as they are.
void RegionEditor::paint_marks(QPainter& painter, double scale) const {
  painter.setPen(Qt::NoPen);
  for (std::size_t i = 0; i < dots_.size(); ++i) {
    QColor colour = colour_of(i < dot_features_.size() ? dot_features_[i] : Feature::surface);
    colour.setAlpha(200);
    painter.setBrush(colour);
    painter.drawEllipse(widget_point(dots_[i]), 1.6 / scale, 1.6 / scale);
  }
  for (std::size_t r = 0; r < drawing_.regions().size(); ++r)
    if (drawing_.regions()[r].side == side_)
      paint_region(painter, drawing_.regions()[r], true, drawing_.selected() == r, scale);
  if (!guide_.empty()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kGuide, 1.4 / scale));
    painter.drawPolyline(on_screen(guide_));
  }
  if (guide_point_) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kGuide, 1.4 / scale));
    painter.drawEllipse(widget_point(*guide_point_), 5.0 / scale, 5.0 / scale);
  }
  const stereo::Region* unfinished = drawing_.unfinished();
  if (unfinished == nullptr || unfinished->side != side_) return;
  paint_region(painter, *unfinished, false, false, scale);
  const QColor colour = colour_of(unfinished->feature);
  if (pointer_) {
    painter.setPen(QPen(colour, 1.5 / scale, Qt::DotLine));
    painter.drawLine(widget_point(unfinished->polygon.back()), *pointer_);
  }
  const bool closes = pointer_ && drawing_.click_at(place_at(*pointer_)) == Click::close;
  painter.setPen(QPen(colour, 2.0 / scale));
  painter.setBrush(closes ? QBrush(colour) : QBrush(kDark));
  const double radius = (closes ? 6.5 : 4.5) / scale;
  painter.drawEllipse(widget_point(unfinished->polygon.front()), radius, radius);
}

void RegionEditor::paint_loupe(QPainter& painter) {
  const QPointF from = *pointer_;
  QPointF middle = from + QPointF(kLoupeDistance, -kLoupeDistance) * 0.75;
  if (middle.x() + kLoupeRadius > width()) middle.setX(from.x() - 0.75 * kLoupeDistance);
  if (middle.y() - kLoupeRadius < 0.0) middle.setY(from.y() + 0.75 * kLoupeDistance);
  QPainterPath glass;
  glass.addEllipse(middle, kLoupeRadius, kLoupeRadius);
  painter.save();
  painter.setClipPath(glass);
  painter.fillPath(glass, Qt::black);
  painter.translate(middle);
  painter.scale(kLoupeScale, kLoupeScale);
  painter.translate(-from);
  draw_picture(painter);
  paint_marks(painter, kLoupeScale);
  painter.restore();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(12, 16, 20), 4.0));
  painter.drawEllipse(middle, kLoupeRadius, kLoupeRadius);
  painter.setPen(QPen(QColor(190, 200, 206), 1.5));
  painter.drawEllipse(middle, kLoupeRadius, kLoupeRadius);
  painter.setPen(QPen(QColor(255, 255, 255, 170), 1.0));
  for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
    painter.drawLine(middle + 5.0 * arm, middle + 14.0 * arm);
}

void RegionEditor::paint_over(QPainter& painter) {
  if (!veil_.isNull())
    painter.drawImage(
        QRectF(widget_point({-0.5, -0.5}), widget_point({picture().width - 0.5, picture().height - 0.5})),
        veil_);
  paint_marks(painter, 1.0);
  if (loupe_ && pointer_ && (drawing_.tool() || drawing_.dragged())) paint_loupe(painter);
}

}  // namespace glisson::ui
