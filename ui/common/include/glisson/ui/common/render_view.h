// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <array>
#include <memory>
#include <set>

#include "glisson/ui/scene/patient_scene.h"

class QImage;
class QLabel;

namespace glisson::ui {

class LassoLine;

/// A patient in three dimensions: VTK inside a Qt 6 widget. Left drag turns, middle drag moves, wheel and
/// right drag zoom, a click that does not drag picks; with the lasso, left drag
/// draws. Call update() after the scene has changed.
///
/// VTK draws into memory, from where the picture is painted as any other. A QOpenGLWidget would make Qt put
/// the whole window together by OpenGL at every change of any widget, even while it is hidden: without a
/// graphics card that costs more than the live overlay itself. The OpenGL is the display's, a card's where
/// there is one; scene::OffscreenRenderer, which needs no display, may have Mesa's software only.
class RenderView : public QWidget {
  Q_OBJECT
 public:
  explicit RenderView(QWidget* parent = nullptr);
  ~RenderView() override;

  /// The default surface format that VTK needs; to be set before the QApplication is made.
  static void prepare_surface_format();

  scene::PatientScene& patient() { return *patient_; }
  /// The scene is drawn anew as soon as it is seen. A repaint for any other reason takes the picture there
  /// is.
  void update();
  /// What is shown; null: nothing was drawn yet, or this computer has no OpenGL that serves.
  const QImage& picture() const;
  double aspect() const { return static_cast<double>(width()) / std::max(1, height()); }
  /// Shown in the view's middle while there is nothing to see. Empty: nothing.
  void set_hint(const QString& hint);
  void set_title(const QString& title);
  /// Letters of the patient's sides at the view's edges. For scenes in the CT's frame.
  void show_orientation();
  /// From now on a left drag draws a closed line instead of turning.
  void set_lasso(bool on);
  /// Drops the line that is being drawn.
  void drop_lasso();
  /// Whoever takes the clicks of this view for a while says so: meanwhile none means anything else.
  void set_taken(const QObject* by, bool on);
  bool is_taken() const { return lassoing_ || !takers_.empty(); }
  /// Homogeneous scene point (metres) to homogeneous place in the view ([0, 1] from the top left corner); the
  /// third component is positive before the viewer.
  Eigen::Matrix<double, 3, 4> view_from_scene() const;
  QSize sizeHint() const override { return {360, 320}; }
  QSize minimumSizeHint() const override { return {160, 140}; }

 signals:
  /// A place in the view, [0, 1] from the top left corner.
  void clicked(double x, double y);
  /// While nobody takes the clicks.
  void double_clicked();
  /// A closed line was drawn, in the same coordinates.
  void lassoed(const QPolygonF& outline, Qt::KeyboardModifiers keys);
  void drawn();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  struct Impl;
  bool begin_drawing();
  void draw();
  void update_letters();
  void place_letters();
  void pass_on(QMouseEvent* event, unsigned long vtk_event);

  std::unique_ptr<scene::PatientScene> patient_;
  std::unique_ptr<Impl> impl_;
  QLabel* hint_ = nullptr;
  QLabel* title_ = nullptr;
  LassoLine* lasso_ = nullptr;
  bool lassoing_ = false;
  std::set<const QObject*> takers_;
  std::array<QLabel*, 4> letters_{};  ///< left, right, top, bottom; null: not shown
  scene::ViewLetters shown_letters_;
};

}  // namespace glisson::ui
