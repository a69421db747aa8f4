// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/again_model.h"
#include "glisson/ui/guidance/correction_model.h"
#include "glisson/ui/guidance/live_picture.h"
#include "glisson/ui/guidance/live_view_model.h"
#include "glisson/ui/guidance/moments_model.h"
#include "glisson/ui/guidance/timeline_bar.h"

class QBoxLayout;
class QToolButton;

namespace glisson::ui {

/// The augmented picture, with what is said of it above and below, and the way through the video. Keys, while
/// it has the focus: space, arrows, Home and End (see TimelineBar), F11 the whole screen, P saves the
/// picture, B shows the raw picture beside it, V the right one with its overlay, R registers again, C
/// corrects by hand, K keeps the moment, Ctrl+Z takes a correction back, Esc lets go of what the hand holds,
/// of a kept moment, of the choice, or of the whole screen.
class LiveView : public QWidget {
  Q_OBJECT
 public:
  /// All outlive the view.
  LiveView(LiveViewModel& model, ReviewModel& review, CorrectionModel& correction, AgainModel& again,
           MomentsModel& moments, QWidget* parent = nullptr);
  ~LiveView() override;
  const LivePicture& picture() const { return *picture_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  /// Of the window that this view is in.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show_picture();
  /// The raw picture beside the other or below it, whichever leaves both larger.
  void arrange();
  void tell_screen();
  QLayout* make_pictures();
  void add_buttons();
  /// A hand corrects in it.
  void join_correction(LivePicture* picture, StereoView view);
  QToolButton* add_button(const char* name, const QString& text, const QString& tip);
  void switch_whole_screen();
  void save_picture();

  LiveViewModel& model_;
  ReviewModel& review_;
  CorrectionModel& correction_;
  AgainModel& again_;
  MomentsModel& moments_;
  TimelineBar* timeline_;
  QPointer<LiveView> whole_screen_;  ///< shown on the whole screen for this one
  LivePicture* picture_;
  LivePicture* right_;    ///< the right camera's, beside it, where it is wanted
  PictureView* raw_;      ///< likewise
  QBoxLayout* pictures_;  ///< of all
  QToolButton *show_raw_, *show_right_;
  Couplings couplings_;
};

}  // namespace glisson::ui
