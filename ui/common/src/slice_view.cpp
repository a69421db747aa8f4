// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/slice_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QWheelEvent>
#include <cmath>

#include "glisson/ui/common/lasso_line.h"
#include "glisson/ui/common/slice_lines.h"
#include "glisson/ui/scene/difference_overlay.h"
#include "glisson/ui/scene/picture_image.h"
#include "glisson/volume/axes.h"
#include "slice_measures.h"
#include "slice_texts.h"

namespace glisson::ui {
namespace {

constexpr double kMarkerReach = 4e-3;  ///< metres from the slice within which a marker is drawn
constexpr int kFlash = 500;            ///< milliseconds that a preview is bright, and then dim
constexpr double kReach = 7.0;         ///< pixels of the widget within which the pointer takes an edge
constexpr double kSlabNotch = 1e-3;    ///< metres that a notch of the wheel makes a slab thicker
constexpr double kTremble = 3.0;       ///< pixels of the widget: a drag is longer

QColor colour_of(Label label) {
  const auto rgb = structure_colour(label);
  return QColor::fromRgbF(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]));
}

}  // namespace

SliceView::SliceView(ViewState& state, scene::Plane plane, QWidget* parent)
    : QWidget(parent), state_(state), plane_(plane) {
  setMouseTracking(true);
  setFocusPolicy(Qt::WheelFocus);
  setToolTip(
      tr("Click: crosshair. Wheel: next slice. Right drag: contrast. Middle drag: move. Ctrl + wheel: zoom. "
         "Double click: this view alone. Right click: menu."));
  setToolTipDuration(4000);
  flash_ = new QTimer(this);
  flash_->setInterval(kFlash);
  connect(flash_, &QTimer::timeout, this, [this] {
    bright_ = !bright_;
    update();
  });
  connect(&state_, &ViewState::volume_changed, this, [this] {
    drawing_.clear();
    refresh_slice();
    refresh_overlays();
  });
  connect(&state_, &ViewState::labels_changed, this, &SliceView::refresh_slice);
  connect(&state_, &ViewState::crosshair_changed, this, &SliceView::refresh_slice);
  connect(&state_, &ViewState::style_changed, this, &SliceView::refresh_slice);
  connect(&state_, &ViewState::overlays_changed, this, &SliceView::refresh_overlays);
  connect(&state_, &ViewState::markers_changed, this, qOverload<>(&QWidget::update));
  connect(&state_, &ViewState::ellipsoids_changed, this, qOverload<>(&QWidget::update));
  connect(&state_, &ViewState::hand_changed, this, &SliceView::show_hand);
  connect(&state_.measures(), &MeasureBook::tool_changed, this, &SliceView::show_hand);
  connect(&state_.measures(), &MeasureBook::changed, this, qOverload<>(&QWidget::update));
  connect(&state_, &ViewState::brush_changed, this, qOverload<>(&QWidget::update));
  connect(&state_, &ViewState::line_changed, this, qOverload<>(&QWidget::update));
  connect(&state_, &ViewState::box_changed, this, qOverload<>(&QWidget::update));
  connect(&state_, &ViewState::pointer_changed, this, [this] {
    if (state_.hand() == Hand::brush) update();
  });
  connect(&state_, &ViewState::gesture_dropped, this, [this] {
    dragging_ = false;
    lasso_.clear();
    state_.measures().drop();
    update();
  });
  refresh_slice();
}

void SliceView::show_hand() {
  dragging_ = false;
  lasso_.clear();
  setCursor(has_tool() ? Qt::CrossCursor : Qt::ArrowCursor);
  update();
}

void SliceView::refresh_slice() {
  if (!state_.image() || state_.image()->empty()) {
    const bool was_there = slice_.width > 0;
    slice_ = {};
    slice_.plane = plane_;
    drawing_.clear();
    image_ = shown_ = {};
    if (was_there) emit slice_changed();
    update();
    return;
  }
  const scene::SliceGeometry wanted = scene::slice_geometry(state_.image()->grid, plane_, state_.crosshair());
  const QRect drawn = drawing_.draw(state_.image(), state_.labels(), wanted, state_.style());
  const bool whole = drawn.size() == QSize(wanted.width, wanted.height);
  const bool moved = slice_.width == 0 || wanted.origin != slice_.origin;
  slice_ = wanted;
  overlay_is_stale_ = true;
  if (!drawn.isEmpty()) {
    image_ = scene::view_as_image(drawing_.picture());
    if (whole)
      shown_ = {};
    else
      redraw(drawn);
    if (whole || moved) emit slice_changed();
  }
  update();
}

void SliceView::refresh_overlays() {
  overlay_is_stale_ = true;
  if (state_.preview() && !flash_->isActive()) flash_->start();
  if (!state_.preview()) {
    flash_->stop();
    bright_ = true;
  }
  update();
}

void SliceView::redraw(const QRect& pixels) {
  if (shown_.isNull()) return;  // is made when it is painted
  const QTransform transform = widget_from_pixel();
  QPainter painter(&shown_);
  // Interpolation reaches a pixel beyond those that changed.
  const QRectF area =
      transform.mapRect(QRectF(pixels).translated(-0.5, -0.5)).adjusted(-2, -2, 2, 2) & QRectF(rect());
  painter.setClipRect(area);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setTransform(transform);
  painter.drawImage(QPointF(-0.5, -0.5), image_);
}

QTransform SliceView::widget_from_pixel() const {
  if (slice_.width == 0) return {};
  const double fit =
      std::min(static_cast<double>(width()) / slice_.width, static_cast<double>(height()) / slice_.height);
  const double scale = fit * zoom_;
  QTransform transform;
  transform.translate(0.5 * width() + pan_.x(), 0.5 * height() + pan_.y());
  transform.scale(scale, scale);
  transform.translate(-0.5 * slice_.width + 0.5, -0.5 * slice_.height + 0.5);  // pixel (0, 0) is a centre
  return transform;
}

QPointF SliceView::widget_point(const Point<CtFrame>& p) const {
  const Eigen::Vector2d pixel = slice_.pixel_of(p);
  return widget_from_pixel().map(QPointF(pixel.x(), pixel.y()));
}

Point<CtFrame> SliceView::p_in_ct(const QPointF& widget) const {
  const QPointF pixel = widget_from_pixel().inverted().map(widget);
  return slice_.p_in_ct({pixel.x(), pixel.y()});
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(0, 0, 0));
  if (image_.isNull()) {
    painter.setPen(QColor(120, 130, 138));
    painter.drawText(rect(), Qt::AlignCenter, tr("No volume"));
    return;
  }
  const double ratio = devicePixelRatioF();
  if (shown_.isNull()) {
    shown_ = QImage(size() * ratio, QImage::Format_RGB32);
    shown_.setDevicePixelRatio(ratio);
    shown_.fill(Qt::black);
    redraw(QRect(0, 0, slice_.width, slice_.height));
  }
  painter.drawImage(QPointF(0, 0), shown_);
  painter.setRenderHints(QPainter::SmoothPixmapTransform | QPainter::Antialiasing);
  paint_overlay(painter);
  if (state_.box())
    paint_box(painter, *state_.box(), slice_, widget_from_pixel(), state_.hand() == Hand::box);
  if (state_.line()) paint_line(painter);
  paint_marks(painter);
  paint_lasso(painter, widget_from_pixel().map(lasso_));
  if (state_.hand() == Hand::brush && state_.pointer() && !state_.is_measuring()) paint_brush(painter);
  paint_measures(painter);
  paint_texts(painter, QRectF(rect()), slice_, shown_text(), slab_text());
}

void SliceView::resizeEvent(QResizeEvent*) { shown_ = {}; }

void SliceView::paint_overlay(QPainter& painter) {
  if (overlay_is_stale_) {
    overlay_is_stale_ = false;
    overlay_ = {};
    const LabelVolume* labels = state_.labels() ? &state_.labels()->voxels : nullptr;
    if (state_.evolving())
      overlay_ = scene::outline_overlay(*state_.evolving(), slice_);
    else if (state_.offer() && labels != nullptr &&
             labels->brick_count() == state_.offer()->labels.voxels.brick_count())
      overlay_ =
          scene::difference_overlay(*labels, state_.offer()->labels.voxels, state_.offer()->hand, slice_);
    else if (state_.preview() && labels != nullptr &&
             labels->brick_count() == state_.preview()->voxels.brick_count())
      overlay_ = scene::change_overlay(*labels, state_.preview()->voxels, slice_);
  }
  if (overlay_.isNull()) return;
  painter.setTransform(widget_from_pixel());
  painter.setOpacity(bright_ ? 1.0 : 0.3);
  painter.drawImage(QPointF(-0.5, -0.5), overlay_);
  painter.setOpacity(1.0);
  painter.resetTransform();
}

void SliceView::paint_brush(QPainter& painter) const {
  const PointerPlace& pointer = *state_.pointer();
  const BrushTip& brush = state_.brush();
  const double off = std::abs(slice_.distance_of(pointer.p));
  if (off > brush.radius) return;
  const double radius = std::sqrt(brush.radius * brush.radius - off * off);  // metres, in this slice
  const auto draw = [&] {
    if (brush.ball || pointer.plane == plane_) {
      const double pixels = radius / slice_.right.norm() * widget_from_pixel().m11();
      painter.drawEllipse(widget_point(pointer.p), pixels, pixels);
      return;
    }
    // A disc is seen from its edge.
    const Eigen::Vector3d along =
        radius * Eigen::Vector3d::Unit(3 - scene::normal_axis(plane_) - scene::normal_axis(pointer.plane));
    painter.drawLine(widget_point(Point<CtFrame>(pointer.p.xyz - along)),
                     widget_point(Point<CtFrame>(pointer.p.xyz + along)));
  };
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 200), 3.0));
  draw();
  painter.setPen(
      QPen(brush.label == structure::kBackground ? QColor(Qt::white) : colour_of(brush.label), 1.5));
  draw();
}

void SliceView::paint_line(QPainter& painter) const {
  const SliceLine& line = *state_.line();
  constexpr double kHere = 1e-6;  // metres: a place within this of the slice was taken from it
  if (line.place.plane != plane_ || std::abs(slice_.distance_of(line.place.p)) > kHere) return;
  QPolygonF outline;
  outline.reserve(line.corners.rows());
  for (Eigen::Index n = 0; n < line.corners.rows(); ++n)
    outline << widget_point(Point<CtFrame>(Eigen::Vector3d(line.corners.row(n).transpose())));
  paint_outline(painter, outline, colour_of(line.label), line.open);
}

void SliceView::paint_measures(QPainter& painter) const {
  const auto on_widget = [this](const MeasureLine& line) {
    return QLineF(widget_point(Point<CtFrame>(line.from)), widget_point(Point<CtFrame>(line.to)));
  };
  const auto paint = [&](const Measure& measure) {
    // It belongs to its slice: elsewhere it would measure something else.
    if (measure.plane != plane_ ||
        std::abs(slice_.distance_of(Point<CtFrame>(measure.line.from))) > 0.5 * step_length())
      return;
    const auto across = measure.across ? std::optional(on_widget(*measure.across)) : std::nullopt;
    paint_measure(painter, QRectF(rect()), on_widget(measure.line), across, MeasureBook::text(measure));
  };
  for (const Measure& measure : state_.measures().measures()) paint(measure);
  if (const auto drawn = state_.measures().drawn()) paint(*drawn);
}

void SliceView::paint_marks(QPainter& painter) const {
  const QPointF cross = widget_point(state_.crosshair());
  // The lines have the colours of the planes that they are the traces of, and spare the crossing.
  const bool axial = plane_ == scene::Plane::axial, sagittal = plane_ == scene::Plane::sagittal;
  QColor vertical = plane_colour(sagittal ? scene::Plane::coronal : scene::Plane::sagittal);
  QColor horizontal = plane_colour(axial ? scene::Plane::coronal : scene::Plane::axial);
  vertical.setAlpha(150);
  horizontal.setAlpha(150);
  constexpr double kGap = 7.0;
  painter.setPen(QPen(vertical, 1.0));
  painter.drawLine(QPointF(cross.x(), 0), QPointF(cross.x(), cross.y() - kGap));
  painter.drawLine(QPointF(cross.x(), cross.y() + kGap), QPointF(cross.x(), height()));
  painter.setPen(QPen(horizontal, 1.0));
  painter.drawLine(QPointF(0, cross.y()), QPointF(cross.x() - kGap, cross.y()));
  painter.drawLine(QPointF(cross.x() + kGap, cross.y()), QPointF(width(), cross.y()));
  for (const scene::Marker& marker : state_.markers())
    paint_disc(painter, marker.p, colour_of(marker.structure));
  for (const scene::EllipsoidMark& mark : state_.ellipsoids()) {
    const Points line = scene::cut(mark, slice_);
    QPolygonF outline;
    outline.reserve(line.rows());
    for (Eigen::Index n = 0; n < line.rows(); ++n)
      outline << widget_point(Point<CtFrame>(Eigen::Vector3d(line.row(n).transpose())));
    paint_outline(painter, outline, mark.colour, false);
  }
  for (const scene::EllipsoidMark& mark : state_.ellipsoids()) paint_disc(painter, mark.p, mark.colour);
}

void SliceView::paint_disc(QPainter& painter, const Eigen::Vector3d& p, QColor colour) const {
  const double off = std::abs(slice_.distance_of(Point<CtFrame>(p)));
  if (off > kMarkerReach) return;
  painter.setPen(QPen(Qt::black, 1.5));
  colour.setAlphaF(static_cast<float>(1.0 - 0.6 * off / kMarkerReach));
  painter.setBrush(colour);
  painter.drawEllipse(widget_point(Point<CtFrame>(p)), 5.0, 5.0);
}

QString SliceView::shown_text() const {
  return tr("%1  WL %2  WW %3")
      .arg(preset_text(state_.preset()))
      .arg(qRound(state_.style().level))
      .arg(qRound(state_.style().width));
}

QString SliceView::slab_text() const {
  return state_.shows_slab() ? tr("MIP %1 mm").arg(1e3 * state_.slab_thickness(), 0, 'f', 0) : QString();
}

void SliceView::tell(SliceGesture::Phase phase, const QMouseEvent& event) {
  state_.gesture({phase, slice_, p_in_ct(event.position()), event.modifiers(), kReach * metres_per_pixel()});
}

double SliceView::metres_per_pixel() const { return slice_.right.norm() / widget_from_pixel().m11(); }

void SliceView::begin_gesture(const QMouseEvent& event) {
  const Point<CtFrame> p = p_in_ct(event.position());
  if (state_.is_measuring()) {
    dragging_ = true;
    state_.measures().begin(plane_, p);
    return;
  }
  switch (state_.hand()) {
    case Hand::crosshair:
      state_.set_crosshair(p);
      return;
    case Hand::point:
      state_.pick(p);
      break;
    case Hand::span:
    case Hand::brush:
    case Hand::lasso:
    case Hand::box:
      dragging_ = true;
      lasso_.clear();
      if (state_.hand() == Hand::lasso) lasso_ << widget_from_pixel().inverted().map(event.position());
      break;
  }
  tell(SliceGesture::Phase::begin, event);
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  moved_ = false;
  if (slice_.width > 0 && event->button() == Qt::LeftButton) begin_gesture(*event);
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (slice_.width == 0) return;
  const QPointF moved = event->position() - last_;
  const Point<CtFrame> p = p_in_ct(event->position());
  if ((event->position() - pressed_).manhattanLength() > kTremble) moved_ = true;
  if (moved_ || !(event->buttons() & Qt::RightButton)) last_ = event->position();
  if (event->buttons() & Qt::RightButton) {
    if (!moved_) return;
    const double speed = state_.style().width / 300.0;
    state_.set_window(state_.style().level - speed * moved.y(), state_.style().width + speed * moved.x());
  } else if (event->buttons() & Qt::MiddleButton) {
    pan_ += moved;
    shown_ = {};
    update();
  } else if (state_.measures().is_drawing()) {
    state_.measures().move(p);
  } else if (dragging_) {
    if (state_.hand() == Hand::lasso) lasso_ << widget_from_pixel().inverted().map(event->position());
    tell(SliceGesture::Phase::move, *event);
    update();
  } else if ((event->buttons() & Qt::LeftButton) && !has_tool()) {
    state_.set_crosshair(p);
  }
  state_.set_pointer(PointerPlace{plane_, p});
  emit hovered(p);
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton) {
    if (moved_)
      state_.keep_window();
    else if (slice_.width > 0)
      emit menu_wanted(event->globalPosition().toPoint());
  }
  if (event->button() != Qt::LeftButton || !dragging_) return;
  dragging_ = false;
  if (state_.is_measuring()) return state_.measures().end(kTremble * metres_per_pixel());
  lasso_.clear();
  tell(SliceGesture::Phase::end, *event);
  update();
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  // With a tool, a double click is two clicks.
  if (event->button() == Qt::LeftButton && slice_.width > 0 && !has_tool())
    emit double_clicked();
  else
    mousePressEvent(event);
}

void SliceView::show_whole() {
  zoom_ = 1.0;
  pan_ = {};
  shown_ = {};
  update();
}

bool SliceView::event(QEvent* event) {
  // No tooltip under the brush.
  if (event->type() == QEvent::ToolTip && has_tool()) return true;
  return QWidget::event(event);
}

void SliceView::wheelEvent(QWheelEvent* event) {
  if (slice_.width == 0) return;
  // With Shift some systems turn the wheel sideways.
  const double notches = (event->angleDelta().y() + event->angleDelta().x()) / 120.0;
  if ((event->modifiers() & Qt::ShiftModifier) && state_.hand() == Hand::brush) {
    state_.turn_brush(notches);
  } else if ((event->modifiers() & Qt::ShiftModifier) && state_.shows_slab()) {
    state_.set_slab_thickness(state_.slab_thickness() + kSlabNotch * notches);
  } else if (event->modifiers() & Qt::ControlModifier) {
    const QPointF pixel = widget_from_pixel().inverted().map(event->position());
    zoom_ = std::clamp(zoom_ * std::pow(1.2, notches), 0.5, 20.0);
    pan_ += event->position() - widget_from_pixel().map(pixel);  // what is under the pointer stays there
    shown_ = {};
    update();
  } else {
    wheel_rest_ += notches;
    const int slices = static_cast<int>(std::trunc(wheel_rest_));
    wheel_rest_ -= slices;
    step(slices);
  }
  // The pointer has not moved, but lies over another slice now.
  state_.set_pointer(PointerPlace{plane_, p_in_ct(event->position())});
  event->accept();
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_PageUp:
      step(event->key() == Qt::Key_Up ? 1 : 10);
      break;
    case Qt::Key_Down:
    case Qt::Key_PageDown:
      step(event->key() == Qt::Key_Down ? -1 : -10);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

void SliceView::step(int slices) {
  if (slices == 0 || !state_.image()) return;
  Point<CtFrame> p = state_.crosshair();
  p.xyz[scene::normal_axis(plane_)] += slices * step_length();
  state_.set_crosshair(p);
}

double SliceView::step_length() const {
  // One slice is a voxel along the volume's axis that is closest to this plane's normal.
  const VolumeGrid& grid = state_.image()->grid;
  return 1e-3 * grid.spacing_mm[axis_along(grid, scene::normal_axis(plane_))];
}

void SliceView::leaveEvent(QEvent*) {
  state_.set_pointer(std::nullopt);
  emit left_view();
}

}  // namespace glisson::ui
