// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <memory>

#include "glisson/model/build.h"
#include "glisson/patient/patient_model.h"
#include "glisson/ui/common/drawable_source.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/label_surface_source.h"
#include "glisson/ui/common/render_view.h"
#include "glisson/ui/common/slice_view.h"
#include "glisson/ui/common/view_bar.h"
#include "glisson/ui/common/view_state.h"
#include "glisson/ui/scene/label_actors.h"

class QLabel;
class QTimer;
class QToolButton;

namespace glisson::ui {

/// The pre-operative patient: axial, coronal and sagittal slices and three dimensions, linked by one
/// crosshair, with a line that says what is under the pointer.
class LinkedViews : public QWidget {
  Q_OBJECT
 public:
  LinkedViews(EngineBridge& engine, ViewState& state, DrawableSource& drawables, QWidget* parent = nullptr);
  ~LinkedViews() override;

  SliceView& slice(scene::Plane plane) { return *slices_[static_cast<std::size_t>(plane)]; }
  RenderView& volume() { return *volume_; }
  const ViewState& state() const { return state_; }
  ViewBar& bar() { return *bar_; }
  /// Lets one of the four fill the place of all (null: all again).
  void show_alone(QWidget* view);
  QWidget* alone() const { return alone_; }
  /// "R 12.3  A 40.0  S 210.5 mm   104 HU   Portal vein"
  QString probe_line() const;
  /// The model's liver surface under a place in the 3D view, in the CT's frame.
  std::optional<Eigen::Vector3d> surface_point(double x, double y) const;
  /// The place of the patient that one sees there: on a structure, a label or a slice.
  std::optional<Eigen::Vector3d> seen_point(double x, double y) const;
  /// Draws these landmarks on the model instead of the case's, until the case's change. CT frame, metres.
  /// While labels are shown instead of the model, they wait until it is back.
  void set_landmarks(const Landmarks& landmarks);
  /// Of the labels, in three dimensions.
  const LabelSurfaceSource& label_surfaces() const { return *label_surfaces_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connect_bar();
  /// Whether Esc has something to leave here before it reaches a panel's tool.
  bool takes_escape() const;
  void leave();
  void connect_labels();
  /// The labels whose surfaces stand in for the model, where they are edited or while there is no model;
  /// null: the model is shown.
  std::shared_ptr<const LabelVolume> labels_in_3d() const;
  void show_labels();
  void show_label_surfaces();
  void lasso(const QPolygonF& outline, Qt::KeyboardModifiers keys);
  QWidget* make_volume_pane();
  void show_case();
  void show_model();
  void show_markers();
  void show_slice(scene::Plane plane);
  void probe(const Point<CtFrame>& p);

  EngineBridge& engine_;
  ViewState& state_;
  DrawableSource& drawables_;
  std::array<SliceView*, 3> slices_{};
  ViewBar* bar_ = nullptr;
  QWidget* alone_ = nullptr;
  QWidget* pointed_ = nullptr;  ///< the view that the pointer was over last
  QWidget* volume_pane_ = nullptr;
  RenderView* volume_ = nullptr;
  QToolButton* slices_toggle_ = nullptr;
  QLabel* position_ = nullptr;
  QLabel* value_ = nullptr;
  QLabel* label_ = nullptr;
  Point<CtFrame> probed_;  ///< the place of which the line below the views tells
  LabelSurfaceSource* label_surfaces_ = nullptr;
  std::unique_ptr<scene::LabelActors> label_actors_;
  QTimer* late_ = nullptr;  ///< delays the 3D view during a stroke, so that the slice is drawn at once
  std::shared_ptr<const scene::DrawableModel> shown_model_;
  std::shared_ptr<const scene::DrawableModel> faced_model_;  ///< that the camera was last turned to
  Landmarks landmarks_;
  std::shared_ptr<const Landmarks> taken_landmarks_;  ///< the case's, when landmarks_ were taken from it
  std::shared_ptr<const model::BuiltModel> taken_model_;
  bool scene_is_empty_ = true;
};

}  // namespace glisson::ui
