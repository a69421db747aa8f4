// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>
#include <deque>

#include "glisson/ui/common/drawable_source.h"
#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/picture_view.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/overlay_worker.h"
#include "glisson/ui/guidance/video_feed.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;

namespace glisson::ui {

/// Registration to the laparoscope's view, then the live augmented picture.
class GuidancePanel : public Panel {
  Q_OBJECT
 public:
  GuidancePanel(EngineBridge& engine, DrawableSource& drawables, QWidget* parent = nullptr);
  ~GuidancePanel() override;

  QWidget* view() override { return view_; }
  /// Augmented pictures shown since the window was opened.
  int pictures_shown() const { return pictures_shown_; }
  /// Records the live view into a file until it is called with an empty path.
  void record_to(const QString& path);
  const PictureView& picture() const { return *picture_; }

 private:
  void build_registration();
  void build_tracking();
  void build_look();
  void build_view();
  void show_case();
  void show_live();
  void show_registered();
  void show_painted(const Picture& picture, const OverlayFrame& overlay, double age, double draw);
  void show_freshness();
  void show_buttons();
  /// Lets go of the last live picture.
  void unfreeze();
  void stop_tracking(const QString& why);
  void toggle_recording();
  OverlayJob make_job();
  QString registration_obstacle() const;
  QString tracking_obstacle() const;

  DrawableSource& drawables_;
  VideoFeed feed_;
  OverlayWorker worker_;
  scene::OverlayStyle style_;
  QPointer<QWidget> view_;  ///< belongs to whoever hosts it
  PictureView* picture_ = nullptr;
  QLabel* live_line_ = nullptr;
  QLabel* banner_ = nullptr;
  TaskButton* register_ = nullptr;
  FiguresTable* registration_figures_ = nullptr;
  QLabel* doubts_ = nullptr;
  QLabel* unchecked_ = nullptr;  ///< says that nobody has checked the model
  TaskButton* track_ = nullptr;
  QPushButton* stop_ = nullptr;
  QPushButton* record_ = nullptr;
  QCheckBox* repeat_ = nullptr;
  QLabel* recording_ = nullptr;
  FiguresTable* live_figures_ = nullptr;
  QTimer freshness_;
  QElapsedTimer since_painted_;
  std::deque<qint64> painted_at_;  ///< milliseconds
  QElapsedTimer clock_;
  double last_age_ = 0.0;
  int shown_index_ = 0;  ///< of the frame on the screen, which may be older than the engine's
  int pictures_shown_ = 0;
  bool is_recording_ = false;
  bool was_tracking_ = false;
  bool repeat_now_ = false;
  /// Tracking has ended, and its last picture stays, marked, as long as its registration is the case's.
  bool is_frozen_ = false;
  std::shared_ptr<const Registration> frozen_registration_;
  Validity shown_validity_ = Validity::not_started;
  std::shared_ptr<const Points> margin_;
  std::shared_ptr<const model::BuiltModel> model_source_;
  std::shared_ptr<const Landmarks> landmarks_source_;
};

}  // namespace glisson::ui
