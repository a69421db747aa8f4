// SPDX-License-Identifier: GPL-3.0-or-later
// The part of LiveViewModel that shows a kept moment.
#include <utility>

#include "glisson/engine/parts/moments.h"
#include "glisson/ui/common/overlay_status.h"
#include "glisson/ui/guidance/live_view_model.h"
#include "glisson/ui/guidance/moment_texts.h"

namespace glisson::ui {

void LiveViewModel::show_kept(std::optional<Kept> kept) {
  if (!kept && !kept_) return;
  if (!kept) {
    drop_kept();
    // Nothing has been followed yet that could take its place.
    if ((playback_.is_tracking || shows_last_picture()) && !live_job_) put_away();
    return show_present();
  }
  ++generation_;
  kept_ = std::move(kept);
  const engine::KeptMoment& moment = *kept_->moment;
  kept_margin_ = std::make_shared<const Points>(moment.margin);
  kept_interest_ = {};
  kept_interest_.lesion = moment.chosen;
  kept_interest_.place = moment.place;
  chosen = moment.chosen;
  draw_kept();
}

void LiveViewModel::drop_kept() {
  if (!kept_) return;
  kept_.reset();
  mark = QString();
  chosen = interest_.lesion;
  emit kept_put_away();
}

void LiveViewModel::draw_kept() {
  const engine::KeptMoment& moment = *kept_->moment;
  OverlayJob job = make_job();
  if (!engine::is_drawn_as_it_was(engine_.state(), moment)) job.model = nullptr;
  job.margin = kept_margin_;
  job.frame = kept_->left;
  job.right = kept_->right;
  job.overlay = moment.overlay;
  job.interest = kept_interest_;
  job.status = overlay_status(moment);
  is_kept_painted_ = false;
  submit(std::move(job));
}

void LiveViewModel::draw_unseen(OverlayJob job) {
  if (!is_kept_painted_) return;  // newest wins: the moment itself would never be drawn
  constexpr int kOfNoGeneration = -1;
  job.generation = kOfNoGeneration;
  worker_.submit(std::move(job));
}

void LiveViewModel::tell_kept(const PaintedOverlay& painted) {
  is_kept_painted_ = true;
  const engine::KeptMoment& moment = *kept_->moment;
  mark = tr("KEPT MOMENT %1 – NOT LIVE").arg(moment.number);
  banner = tr("Kept moment %1, not live: %2").arg(moment.number).arg(moment_time(moment));
  if (!moment.title.empty())
    banner = banner.value() + QLatin1Char('\n') + QString::fromStdString(moment.title);
  const bool as_it_was = engine::is_drawn_as_it_was(engine_.state(), moment);
  if (!as_it_was)
    banner = banner.value() + QLatin1Char('\n') +
             tr("Model or calibration were made anew since: its overlay cannot be drawn as it was. The "
                "picture is shown without.");
  else if (painted.made_from && !painted.made_from->model)
    banner =
        banner.value() + QLatin1Char('\n') + tr("The overlay is being prepared: the picture shows none yet.");
  QString text = tr("Kept moment %1, frame %2, not live").arg(moment.number).arg(moment.overlay.index);
  const Level level = moment.overlay.level();
  const QString why = QString::fromStdString(scene::validity_text(moment.overlay.validity));
  if (level == Level::withdrawn) text += tr("   NO OVERLAY: %1").arg(why);
  if (level == Level::degraded) text += tr("   OUTLINE ONLY: %1").arg(why);
  line = text;
  is_fresh = QVariant(false);
  figures = FigureRows();
  if (as_it_was) return;
  // What was told then is known still.
  for (const LesionVerdict& verdict : moment.overlay.lesions)
    if (verdict.lesion == kept_interest_.lesion && verdict.lesion == moment.chosen)
      numbers = lesion_figures(verdict, level, moment.measures);
}

}  // namespace glisson::ui
