// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/render_view.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderer.h>

#include <QLabel>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QPainter>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include "glisson/ui/common/lasso_line.h"

namespace glisson::ui {

struct RenderView::Impl {
  QOffscreenSurface surface;
  QOpenGLContext context;
  bool is_ready = false, is_refused = false;
  bool is_stale = true;  ///< the scene has changed since it was drawn
  QImage picture;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  QPointF pressed;
  bool dragged = false;
};

RenderView::RenderView(QWidget* parent)
    : QWidget(parent), patient_(std::make_unique<scene::PatientScene>()), impl_(std::make_unique<Impl>()) {
  impl_->window->SetReadyForRendering(false);
  impl_->window->SetOwnContext(0);
  impl_->window->SetMultiSamples(0);
  impl_->window->AddRenderer(&patient_->renderer());
  impl_->interactor->SetRenderWindow(impl_->window);
  impl_->interactor->SetInteractorStyle(impl_->style);
  // Drawing happens in paintEvent only; the interactor's renders become updates.
  impl_->interactor->EnableRenderOff();
  impl_->interactor->Initialize();
  setMinimumSize(120, 100);
  setAttribute(Qt::WA_OpaquePaintEvent);
  title_ = new QLabel(this);
  title_->setProperty("role", "view-title");
  title_->move(8, 6);
  hint_ = new QLabel(this);
  hint_->setProperty("role", "view-hint");
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  for (QLabel* label : {title_, hint_}) label->setAttribute(Qt::WA_TransparentForMouseEvents);
  lasso_ = new LassoLine(this);
}

RenderView::~RenderView() {
  if (!impl_->is_ready || !impl_->context.makeCurrent(&impl_->surface)) return;
  impl_->window->Finalize();
  impl_->context.doneCurrent();
}

void RenderView::prepare_surface_format() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(0);
  format.setSwapInterval(0);
  QSurfaceFormat::setDefaultFormat(format);
}

void RenderView::set_hint(const QString& hint) {
  if (impl_->is_refused) return;  // it says why there is nothing to see
  hint_->setText(hint);
  hint_->setVisible(!hint.isEmpty());
}

void RenderView::set_title(const QString& title) {
  title_->setText(title);
  title_->adjustSize();
}

void RenderView::show_orientation() {
  for (QLabel*& letter : letters_) {
    letter = new QLabel(this);
    letter->setProperty("role", "view-letter");
    letter->setAttribute(Qt::WA_TransparentForMouseEvents);
    letter->show();
  }
  // Not while OpenGL draws: labels are widgets of their own.
  connect(this, &RenderView::drawn, this, &RenderView::update_letters, Qt::QueuedConnection);
}

void RenderView::update_letters() {
  const scene::ViewLetters now = patient_->view_letters();
  if (now == shown_letters_) return;
  shown_letters_ = now;
  const std::array<std::string, 4> texts = {now.left, now.right, now.top, now.bottom};
  for (std::size_t k = 0; k < letters_.size(); ++k) {
    letters_[k]->setText(QString::fromStdString(texts[k]));
    letters_[k]->adjustSize();
  }
  place_letters();
}

void RenderView::place_letters() {
  if (letters_[0] == nullptr) return;
  constexpr int kMargin = 8;
  const auto [left, right, top, bottom] = letters_;
  left->move(kMargin, (height() - left->height()) / 2);
  right->move(width() - kMargin - right->width(), (height() - right->height()) / 2);
  top->move((width() - top->width()) / 2, kMargin);
  bottom->move((width() - bottom->width()) / 2, height() - kMargin - bottom->height());
}

void RenderView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  hint_->setGeometry(rect().adjusted(24, 24, -24, -24));
  place_letters();
  update();
}

void RenderView::update() {
  impl_->is_stale = true;
  QWidget::update();
}

const QImage& RenderView::picture() const { return impl_->picture; }

/// @return whether VTK can draw now.
bool RenderView::begin_drawing() {
  if (impl_->is_refused) return false;
  if (impl_->is_ready) return impl_->context.makeCurrent(&impl_->surface);
  impl_->surface.setFormat(QSurfaceFormat::defaultFormat());
  impl_->surface.create();
  impl_->context.setFormat(QSurfaceFormat::defaultFormat());
  const bool serves = impl_->context.create() && impl_->context.format().version() >= qMakePair(3, 2) &&
                      impl_->context.makeCurrent(&impl_->surface);
  if (!serves) {
    set_hint(
        tr("No picture in three dimensions: this computer offers no OpenGL 3.2. glisson doctor tells more."));
    impl_->is_refused = true;
    return false;
  }
  impl_->window->SetReadyForRendering(true);
  impl_->window->SetMapped(1);
  impl_->window->SetIsCurrent(true);
  impl_->window->SetSupportsOpenGL(1);
  impl_->window->InitializeFromCurrentContext();
  impl_->is_ready = true;
  return true;
}

void RenderView::draw() {
  if (!begin_drawing()) return;
  const double ratio = devicePixelRatioF();
  const int w = std::max(1, static_cast<int>(width() * ratio)),
            h = std::max(1, static_cast<int>(height() * ratio));
  vtkGenericOpenGLRenderWindow& window = *impl_->window;
  const int* const before = window.GetSize();
  const bool is_resized = before[0] != w || before[1] != h;
  window.SetSize(w, h);
  impl_->interactor->SetSize(w, h);
  if (is_resized) patient_->keep_in_view();
  patient_->renderer().ResetCameraClippingRange();
  window.Render();
  if (impl_->picture.size() != QSize(w, h)) impl_->picture = QImage(w, h, QImage::Format_RGB32);
  impl_->picture.setDevicePixelRatio(ratio);
  window.GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  QOpenGLExtraFunctions* gl = impl_->context.extraFunctions();
  gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl->glReadPixels(0, 0, w, h, GL_BGRA, GL_UNSIGNED_BYTE, impl_->picture.bits());
  gl->glBindFramebuffer(GL_FRAMEBUFFER, 0);
  impl_->context.doneCurrent();
  impl_->picture.mirror(false, true);  // OpenGL begins below
  emit drawn();
}

void RenderView::paintEvent(QPaintEvent*) {
  if (impl_->is_stale) {
    impl_->is_stale = false;
    draw();
  }
  QPainter painter(this);
  if (impl_->picture.isNull())
    painter.fillRect(rect(), Qt::black);
  else
    painter.drawImage(0, 0, impl_->picture);
}

void RenderView::pass_on(QMouseEvent* event, unsigned long vtk_event) {
  const double ratio = devicePixelRatioF();
  const auto keys = event->modifiers();
  impl_->interactor->SetEventInformationFlipY(
      static_cast<int>(event->position().x() * ratio), static_cast<int>(event->position().y() * ratio),
      keys.testFlag(Qt::ControlModifier) ? 1 : 0, keys.testFlag(Qt::ShiftModifier) ? 1 : 0);
  impl_->interactor->InvokeEvent(vtk_event);
  update();
}

void RenderView::set_lasso(bool on) {
  lassoing_ = on;
  lasso_->clear();
  setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
}

void RenderView::set_taken(const QObject* by, bool on) {
  if (on)
    takers_.insert(by);
  else
    takers_.erase(by);
}

void RenderView::drop_lasso() { lasso_->clear(); }

Eigen::Matrix<double, 3, 4> RenderView::view_from_scene() const {
  vtkNew<vtkMatrix4x4> clip;
  clip->DeepCopy(
      patient_->renderer().GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect(), -1.0, 1.0));
  const auto row = [&](int r) {
    return Eigen::RowVector4d(clip->GetElement(r, 0), clip->GetElement(r, 1), clip->GetElement(r, 2),
                              clip->GetElement(r, 3));
  };
  Eigen::Matrix<double, 3, 4> view;
  view << 0.5 * (row(3) + row(0)), 0.5 * (row(3) - row(1)), row(3);
  return view;
}

void RenderView::mousePressEvent(QMouseEvent* event) {
  if (lassoing_ && event->button() == Qt::LeftButton) return lasso_->start(event->position());
  impl_->pressed = event->position();
  impl_->dragged = false;
  if (event->button() == Qt::LeftButton) pass_on(event, vtkCommand::LeftButtonPressEvent);
  if (event->button() == Qt::MiddleButton) pass_on(event, vtkCommand::MiddleButtonPressEvent);
  if (event->button() == Qt::RightButton) pass_on(event, vtkCommand::RightButtonPressEvent);
}

void RenderView::mouseMoveEvent(QMouseEvent* event) {
  if (!lasso_->line().isEmpty()) return lasso_->extend(event->position());
  constexpr double kClickReach = 4.0;  // pixels
  if ((event->position() - impl_->pressed).manhattanLength() > kClickReach) impl_->dragged = true;
  if (impl_->dragged) pass_on(event, vtkCommand::MouseMoveEvent);
}

void RenderView::mouseReleaseEvent(QMouseEvent* event) {
  if (lassoing_ && event->button() == Qt::LeftButton) {
    const QPolygonF outline = QTransform::fromScale(1.0 / width(), 1.0 / height()).map(lasso_->line());
    lasso_->clear();
    if (outline.size() > 2) emit lassoed(outline, event->modifiers());
    return;
  }
  if (event->button() == Qt::LeftButton) pass_on(event, vtkCommand::LeftButtonReleaseEvent);
  if (event->button() == Qt::MiddleButton) pass_on(event, vtkCommand::MiddleButtonReleaseEvent);
  if (event->button() == Qt::RightButton) pass_on(event, vtkCommand::RightButtonReleaseEvent);
  if (event->button() == Qt::LeftButton && !impl_->dragged)
    emit clicked(event->position().x() / width(), event->position().y() / height());
}

void RenderView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || is_taken()) return mousePressEvent(event);
  impl_->dragged = true;  // its release is no click
  emit double_clicked();
}

void RenderView::wheelEvent(QWheelEvent* event) {
  impl_->interactor->InvokeEvent(event->angleDelta().y() > 0 ? vtkCommand::MouseWheelForwardEvent
                                                             : vtkCommand::MouseWheelBackwardEvent);
  update();
  event->accept();
}

}  // namespace glisson::ui
