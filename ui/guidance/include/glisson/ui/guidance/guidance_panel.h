// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>
#include <deque>
#include <optional>

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
  /// Draws what is on the screen once more, in the present style. Live, the next picture has it anyway.
  void redraw();
  /// Nothing is shown: neither a picture nor what was said of it.
  void put_away();
  void submit(OverlayJob job);
  void show_painted(const Picture& picture, const OverlayFrame& overlay, double age, double draw,
                    int generation);
  void show_failed(const QString& message, int generation);
  void show_still(const OverlayFrame& overlay);
  void show_live_figures(const OverlayFrame& overlay, double draw);
  void show_freshness();
  void show_buttons();
  /// Lets go of the last live picture. Its banner stays until something else is shown.
  void unfreeze();
  /// Whether what the feed says concerns the tracking that is on.
  bool is_playing() const;
  void stop_tracking(const QString& why);
  void toggle_recording();
  OverlayJob make_job();
  /// The step to do first: what a registration would be made of is out of date itself, and so would that be
  /// at once. Empty: nothing is.
  QString outdated_input() const;
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
  QString frozen_why_;  ///< said above it
  std::shared_ptr<const Registration> frozen_registration_;
  std::optional<OverlayJob> job_;  ///< the last one
  int generation_ = 0;             ///< pictures of former ones are not shown any more
  Validity shown_validity_ = Validity::not_started;
  std::shared_ptr<const Points> margin_;
  std::shared_ptr<const model::BuiltModel> model_source_;
  std::shared_ptr<const Landmarks> landmarks_source_;
};

}  // namespace glisson::ui
