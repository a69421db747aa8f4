// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>

#include "glisson/ui/common/drawable_source.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/guidance/again_model.h"
#include "glisson/ui/guidance/correction_model.h"
#include "glisson/ui/guidance/guidance_view.h"
#include "glisson/ui/guidance/live_view.h"
#include "glisson/ui/guidance/live_view_model.h"
#include "glisson/ui/guidance/mask_model.h"
#include "glisson/ui/guidance/moments_model.h"
#include "glisson/ui/guidance/openigtlink_model.h"
#include "glisson/ui/guidance/overlay_worker.h"
#include "glisson/ui/guidance/placing_model.h"
#include "glisson/ui/guidance/playback_model.h"
#include "glisson/ui/guidance/recording_model.h"
#include "glisson/ui/guidance/registration_model.h"
#include "glisson/ui/guidance/review_model.h"
#include "glisson/ui/guidance/tool_model.h"

namespace glisson::ui {

/// Registration to the laparoscope's view, then the live augmented picture: puts the boxes and the view
/// together.
class GuidancePanel : public Panel {
  Q_OBJECT
 public:
  GuidancePanel(EngineBridge& engine, DrawableSource& drawables, QWidget* parent = nullptr);
  ~GuidancePanel() override;

  QWidget* view() override { return view_; }
  /// A recording.
  QString wind_up() override;
  /// Augmented pictures shown since the window was opened.
  int pictures_shown() const { return live_.pictures_shown(); }
  /// Records the live view into a file until it is called with an empty path.
  void record_to(const QString& path) { path.isEmpty() ? recording_.stop() : recording_.start(path); }
  const PictureView& picture() const { return view_->live().picture(); }
  const LiveViewModel& live() const { return live_; }

 private:
  /// What a hand does in the picture goes to the organ that it places.
  void join_hands();
  /// Over the picture: where a hand holds the organ, else the place that is compared.
  void show_proposed();
  /// Neither a kept moment nor a former frame stays in the picture.
  void leave_former();
  /// A hand moves the organ that it sees.
  bool can_drag() const;

  OverlayWorker worker_;
  RegistrationModel registration_;
  PlacingModel placing_;
  PlaybackModel playback_;
  ReviewModel review_;
  CorrectionModel correction_;
  AgainModel again_;
  MaskModel mask_;
  RecordingModel recording_;
  LiveViewModel live_;
  MomentsModel moments_;
  OpenIgtLinkModel openigtlink_;
  ToolModel tool_;
  Couplings couplings_;
  QPointer<GuidanceView> view_;  ///< belongs to whoever hosts it
};

}  // namespace glisson::ui
