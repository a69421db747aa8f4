// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/ui/guidance/again_model.h"
#include "glisson/ui/guidance/correction_model.h"
#include "glisson/ui/guidance/live_picture.h"
#include "glisson/ui/guidance/live_view.h"
#include "glisson/ui/guidance/moments_model.h"
#include "glisson/ui/guidance/playback_box.h"

namespace glisson {

/// The live part of the window, without the window.
struct LivePart {
  explicit LivePart(ui::EngineBridge& engine)
      : drawables(engine),
        playback(engine),
        review(engine, playback),
        live(engine, drawables, playback, review, worker),
        playing(engine, playback),
        correction(engine, playback, review),
        again(engine, playback),
        moments(engine, playback, review, live),
        view(live, review, correction, again, moments) {
    view.resize(640, 480);
    view.show();
  }
  ui::OverlayWorker worker;
  ui::DrawableSource drawables;
  ui::PlaybackModel playback;
  ui::ReviewModel review;
  ui::LiveViewModel live;
  ui::PlaybackBox playing;
  ui::CorrectionModel correction;
  ui::AgainModel again;
  ui::MomentsModel moments;
  ui::LiveView view;

  ui::LivePicture* picture() { return view.findChild<ui::LivePicture*>(); }
};

}  // namespace glisson
