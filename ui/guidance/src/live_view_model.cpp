// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/live_view_model.h"

#include <algorithm>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/guidance/lesion_judge.h"
#include "glisson/registration/refusal.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/overlay_status.h"

namespace glisson::ui {
namespace {

constexpr double kFreshSeconds = 0.5;  ///< a live picture that is older is marked
constexpr qint64 kRateWindow = 2000;   ///< milliseconds over which the frame rate is counted
constexpr qint64 kFigures = 250;       ///< milliseconds between two looks at figures: nobody reads faster

}  // namespace

LiveViewModel::LiveViewModel(EngineBridge& engine, DrawableSource& drawables, PlaybackModel& playback,
                             ReviewModel& review, OverlayWorker& worker, QObject* parent)
    : QObject(parent),
      engine_(engine),
      drawables_(drawables),
      playback_(playback),
      review_(review),
      worker_(worker) {
  clock_.start();
  connect(&worker_, &OverlayWorker::painted, this, &LiveViewModel::show_painted);
  connect(&worker_, &OverlayWorker::failed, this, &LiveViewModel::show_failed);
  connect(&playback_, &PlaybackModel::case_read, this, &LiveViewModel::read_case);
  connect(&playback_, &PlaybackModel::begun, this, [this] {
    live_job_.reset();  // of a former playing
    painted_at_.clear();
    since_painted_.invalidate();
    since_figures_.invalidate();
    screen_times_.clear();
  });
  couplings_.add(playback_.frozen_why, [this](const QString& why) {
    if (!why.isEmpty()) show_frozen();
  });
  connect(&review_, &ReviewModel::shown, this, &LiveViewModel::show_moment);
  connect(&review_, &ReviewModel::ended, this, &LiveViewModel::show_present);
  couplings_.add(playback_.is_paused, [this](bool is) {
    if (is) redraw();
    show_freshness();
  });
  couplings_.add(playback_.is_frozen, [this](bool is) {
    if (is && !review_.is_reviewing) redraw();
  });
  connect(&engine_, &EngineBridge::live_changed, this, &LiveViewModel::show_live);
  connect(&drawables_, &DrawableSource::changed, this, [this] {
    interest_.place.reset();  // of another surface
    redraw();
  });
  connect(&freshness_, &QTimer::timeout, this, &LiveViewModel::show_freshness);
  freshness_.start(100);
  read_case();
}

void LiveViewModel::set_style(const scene::OverlayStyle& style) {
  style_ = style;
  redraw();
}

OverlayJob LiveViewModel::make_job() {
  const engine::CaseState& now = engine_.state();
  // One object as long as nothing changes: the painter binds the margin once for it.
  if (now[part::model] != model_source_ || now[part::landmarks] != landmarks_source_) {
    model_source_ = now[part::model];
    landmarks_source_ = now[part::landmarks];
    margin_ = now[part::model]
                  ? std::make_shared<const Points>(engine::effective_landmarks(now).anterior_margin)
                  : nullptr;
  }
  OverlayJob job;
  job.model = drawables_.drawable();
  job.margin = margin_;
  job.rig = now[part::rig];
  job.style = style_;
  job.interest = interest_;
  job.status = overlay_status(now);
  job.model_revision = now.stamp(part::model).revision;
  job.rig_revision = now.stamp(part::rig).revision;
  return job;
}

void LiveViewModel::read_case() {
  if (const std::uint64_t number = engine_.snapshot()->case_number; number != interest_of_) {
    interest_of_ = number;
    drop_kept();
    interest_ = {};  // another patient's lesion is not chosen because one of the former was
    chosen = 0;
  }
  const bool tracking = playback_.is_tracking;
  // What is still being painted is not live, or of the case as it was, or of another one.
  const bool is_still = !tracking && !shows_last_picture();
  const bool begins = tracking && !was_tracking_;
  if (begins || is_still) ++generation_;
  if (begins) live_job_.reset();  // of a former playing
  if (!tracking && was_tracking_) tell_times();
  was_tracking_ = tracking;
  if (kept_)
    draw_kept();
  else if (is_still)
    show_registered();
  // Where no frame comes, as in a pause, nothing else would take the overlay away.
  const bool was_stale = std::exchange(is_stale_, tracking && live_job_ && is_live_stale());
  if (is_stale_ && !was_stale) show_live();
}

bool LiveViewModel::shows_proposed() const {
  return proposed_ && !playback_.is_tracking && !review_.is_reviewing;
}

bool LiveViewModel::is_live_stale() const {
  return engine_.snapshot()->stage(part::live) == engine::StageState::stale;
}

void LiveViewModel::put_away() {
  job_.reset();
  on_screen_ = {};
  undrawn_.reset();
  emit picture_changed();
  line = QString();
  is_fresh = QVariant();
  figures = FigureRows();
  lesions = LesionRows();
  numbers = FigureRows();
  shown_ = {};
  banner = QString();
}

void LiveViewModel::submit(OverlayJob job) {
  job.generation = generation_;
  job.screen = screen_;
  job.with_raw = with_raw_;
  job.with_right = with_right_;
  job_ = job;
  worker_.submit(std::move(job));
}

void LiveViewModel::set_screen(const QSize& size, bool with_raw, bool with_right) {
  screen_ = size;
  with_raw_ = with_raw;
  if (std::exchange(with_right_, with_right) != with_right) redraw();
}

void LiveViewModel::note_drawn() {
  if (!undrawn_) return;  // by another view already, or not live
  screen_times_.add(*undrawn_, ScreenTimes::Clock::now());
  undrawn_.reset();
}

void LiveViewModel::tell_times() {
  if (screen_times_.count() > 0) emit times_told(screen_times_);
}

void LiveViewModel::redraw() {
  if (kept_) return draw_kept();
  const bool is_standing = review_.is_reviewing || shows_last_picture() || playback_.is_paused;
  if (!is_standing) {
    if (!engine_.snapshot()->tracking) show_registered();
    return;
  }
  if (!job_) return;
  OverlayJob job = *job_;
  job.style = style_;
  job.interest = interest_;
  if (drawables_.drawable()) job.model = drawables_.drawable();
  job.taken.reset();  // it is not live any more
  job.is_live = false;
  job.status.frames_per_second = 0.0;
  submit(std::move(job));
}

void LiveViewModel::show_registered() {
  const engine::CaseState& now = engine_.state();
  if (!now[part::frame]) return put_away();
  OverlayJob job = make_job();
  job.frame = now[part::frame]->frame.left;
  job.right = now[part::frame]->frame.right;
  job.overlay.index = now[part::frame]->frame.index;
  if (now[part::registration]) {
    const bool current = engine_.snapshot()->stage(part::registration) == engine::StageState::current;
    const bool refused = registration::is_refused(*now[part::registration]);
    job.status.refused = current && refused;
    job.overlay.validity = !current ? Validity::stale : refused ? Validity::not_started : Validity::valid;
    job.overlay.nodes_in_camera = now[part::registration]->nodes_in_camera;
    job.overlay.residual = now[part::registration]->residual;
    job.overlay.doubtful = registration::is_in_doubt(*now[part::registration]);
    job.overlay.lesions = lesions_at_start(job.overlay);
  }
  const bool is_of_this_model =
      proposed_ && now[part::model] && proposed_->nodes.rows() == now[part::model]->model.mesh.vertex_count();
  if (is_of_this_model) {
    const int index = job.overlay.index;
    job.overlay = OverlayFrame();
    job.status.refused = false;
    job.overlay.index = index;
    job.overlay.validity = Validity::proposed;
    job.overlay.nodes_in_camera = proposed_->nodes;
  }
  submit(std::move(job));
}

void LiveViewModel::propose(std::optional<Proposed> proposed) {
  if (!proposed && !proposed_) return;
  proposed_ = std::move(proposed);
  if (playback_.is_tracking || review_.is_reviewing || kept_) return;
  proposed_ ? show_registered() : show_present();
}

std::vector<LesionVerdict> LiveViewModel::lesions_at_start(const OverlayFrame& overlay) {
  const engine::CaseState& now = engine_.state();
  if (!now[part::model] || overlay.nodes_in_camera.rows() != now[part::model]->model.mesh.vertex_count())
    return {};
  return guidance::LesionJudge(now[part::model]->model, *now[part::registration]).at_start(overlay.validity);
}

void LiveViewModel::show_live() {
  const engine::CaseState& now = engine_.state();
  if (!now[part::live] || now[part::live]->frame.left.empty() || !engine_.snapshot()->tracking) return;
  if (review_.is_reviewing) return;  // one that was on its way
  OverlayJob job = make_job();
  job.frame = now[part::live]->frame.left;
  job.right = now[part::live]->frame.right;
  job.overlay = now[part::live]->overlay;
  if (is_live_stale()) job.overlay.validity = Validity::stale;
  job.draws_refuted = draws_refuted(job.overlay);
  job.taken = playback_.feed().sent_at(now[part::live]->frame.index);
  // Not those that were on their way, nor one of which nobody knows how old it is.
  job.is_live = job.taken && !playback_.is_paused && !playback_.is_frozen;
  job.source_rate = playback_.feed().frames_per_second();
  job.status.frames_per_second = rate();
  live_job_ = job;
  kept_ ? draw_unseen(std::move(job)) : submit(std::move(job));
}

bool LiveViewModel::draws_refuted(const OverlayFrame& overlay) const {
  return shows_refuted_ && overlay.validity == Validity::surface_apart;
}

void LiveViewModel::show_refuted(bool on) {
  if (shows_refuted_ == on) return;
  shows_refuted_ = on;
  show_live();
}

void LiveViewModel::show_moment(const Moment& moment) {
  drop_kept();
  ++generation_;
  OverlayJob job = make_job();
  job.frame = moment.left;
  job.overlay = moment.overlay;
  submit(std::move(job));
}

void LiveViewModel::show_present() {
  ++generation_;
  if (!playback_.is_tracking && !shows_last_picture()) return show_registered();
  if (!live_job_) {  // nothing has been followed yet
    if (!playback_.is_frozen) return;
    show_registered();
    return show_frozen();
  }
  OverlayJob job = *live_job_;
  if (is_stale_) job.overlay.validity = Validity::stale;
  job.draws_refuted = draws_refuted(job.overlay);
  job.style = style_;
  job.interest = interest_;
  job.taken.reset();
  job.is_live = false;
  job.status.frames_per_second = 0.0;
  submit(std::move(job));
  if (playback_.is_frozen) show_frozen();
}

void LiveViewModel::show_recorded(const OverlayFrame& overlay) {
  banner = tr("Looked at again: frame %1 as it was followed, not live.").arg(overlay.index);
  line = tr("Frame %1, recorded, not live").arg(overlay.index);
  is_fresh = QVariant(false);
  figures = FigureRows();
}

void LiveViewModel::show_frozen() {
  if (review_.is_reviewing || kept_ || shows_proposed()) return;
  banner = playback_.frozen_why.value();
  line = tr("Not live");
  is_fresh = QVariant(false);
}

void LiveViewModel::show_painted(const PaintedOverlay& painted) {
  if (painted.generation != generation_) return;
  const bool goes_on = shows_live_ && painted.is_live && painted.overlay.validity == shown_.validity;
  on_screen_ = painted;
  undrawn_ = painted.is_live ? painted.taken : std::nullopt;
  emit picture_changed();
  ++pictures_shown_;
  last_age_ = painted.age;
  shown_ = painted.overlay;
  shows_live_ = painted.is_live;
  since_painted_.start();
  show_lesions(painted);
  if (kept_) return tell_kept(painted);
  if (review_.is_reviewing) return show_recorded(painted.overlay);
  if (shows_last_picture()) {  // the last live pictures may still come in
    banner = playback_.frozen_why.value();
    return;
  }
  const engine::Snapshot& now = *engine_.snapshot();
  if (!now.tracking || !now.state[part::live]) return show_still(painted.overlay);
  show_live_figures(painted.overlay, painted.draw);
  // Words take the window's time: a change is said at once, an age by the timer.
  if (!goes_on) show_freshness();
}

void LiveViewModel::show_lesions(const PaintedOverlay& painted) {
  const OverlayFrame& overlay = painted.overlay;
  lesions = lesion_rows(overlay.lesions, overlay.level());
  const auto found =
      std::find_if(overlay.lesions.begin(), overlay.lesions.end(),
                   [this](const LesionVerdict& one) { return one.lesion == interest().lesion; });
  numbers = found == overlay.lesions.end() ? FigureRows()
                                           : lesion_figures(*found, overlay.level(), painted.measures);
}

void LiveViewModel::choose(Label lesion) {
  if (interest().lesion == lesion) return;
  interest().lesion = chosen = lesion;
  redraw();
}

void LiveViewModel::choose_at(const Eigen::Vector2d& pixel) {
  const auto& rig = engine_.state()[part::rig];
  if (rig) choose(lesion_at(shown_, rig->left, pixel));
}

void LiveViewModel::mark_at(const Eigen::Vector2d& pixel) {
  const auto& rig = engine_.state()[part::rig];
  const auto& drawable = drawables_.drawable();
  if (!rig || !drawable || shown_.level() == Level::withdrawn) return;
  interest().place = scene::place_at(*drawable, rig->left, shown_, pixel);
  if (interest().place && interest().lesion == 0 && shown_.lesions.size() == 1)
    interest().lesion = chosen = shown_.lesions.front().lesion;
  redraw();
}

void LiveViewModel::touch(const std::optional<guidance::SurfacePlace>& place) {
  if (!place && !is_touched_) return;
  is_touched_ = place.has_value();
  interest_.place = place;  // drawn with the next live picture
}

void LiveViewModel::point_at(const std::optional<Eigen::Vector2d>& pixel) {
  interest().pointer = pixel;
  if (style_.look == scene::Look::focus) redraw();
}

void LiveViewModel::let_go() {
  interest().lesion = 0;
  interest().place.reset();
  chosen = 0;
  redraw();
}

const OverlayFrame* LiveViewModel::followed() const {
  const bool is_of_video = playback_.is_tracking || review_.is_reviewing || shows_last_picture();
  return is_of_video && !kept_ && on_screen_.made_from ? &shown_ : nullptr;
}

void LiveViewModel::show_failed(const QString& message, int generation) {
  if (generation != generation_) return;
  if (kept_) {  // what was on the screen before is old by now
    is_kept_painted_ = true;
    put_away();
    banner = message;
    return;
  }
  // What is on the screen is of the case as it was, unless it says that it is a former picture.
  if (!shows_last_picture() && !engine_.snapshot()->tracking) put_away();
  banner = shows_last_picture() ? playback_.frozen_why.value() + QLatin1Char('\n') + message : message;
}

void LiveViewModel::show_still(const OverlayFrame& overlay) {
  const bool valid = overlay.validity == Validity::valid;
  line = valid ? tr("Registered frame %1, not live").arg(overlay.index)
         : overlay.validity == Validity::proposed && proposed_ ? proposed_->line
                                                               : tr("Frame %1, not live").arg(overlay.index);
  is_fresh = QVariant(false);
  figures = FigureRows();
  banner = QString();
}

void LiveViewModel::show_live_figures(const OverlayFrame& overlay, double draw) {
  const engine::LiveState& live = *engine_.state()[part::live];
  painted_at_.push_back(clock_.elapsed());
  while (painted_at_.back() - painted_at_.front() > kRateWindow) painted_at_.pop_front();
  if (since_figures_.isValid() && since_figures_.elapsed() < kFigures) return;
  since_figures_.start();
  const auto ms = [](double value) { return tr("%1 ms").arg(value, 0, 'f', 0); };
  const auto screen = [&](double share) { return 1e3 * screen_times_.percentile(share).value_or(0.0); };
  figures =
      FigureRows{{tr("Tracked points, left / right"),
                  tr("%1 / %2").arg(overlay.tracked_left).arg(overlay.tracked_right)},
                 {tr("Pairs"), QString::number(overlay.pairs)},
                 {tr("Residual (not an accuracy)"), tr("%1 mm").arg(1e3 * overlay.residual, 0, 'f', 2)},
                 {tr("Tracking and mechanics"), ms(overlay.milliseconds)},
                 {tr("Drawing"), ms(1e3 * draw)},
                 {tr("Camera to screen, median / 99 %"),
                  tr("%1 / %2 ms").arg(screen(0.5), 0, 'f', 0).arg(screen(0.99), 0, 'f', 0)},
                 {tr("On the screen"), tr("%1 frames/s").arg(screen_times_.rate(), 0, 'f', 1)},
                 {tr("Frames late / dropped"), tr("%1 / %2").arg(live.frames_late).arg(live.frames_dropped)}};
}

QString LiveViewModel::save_picture(const Picture& held, const QString& path) {
  if (held.empty()) return tr("There is no picture to save.");
  try {
    stereo::write_picture(path.toStdString(), held);
  } catch (const Error& error) {
    return error_text(error.what());
  }
  return {};
}

double LiveViewModel::rate() const {
  if (painted_at_.size() < 2) return 0.0;
  const auto span = std::max<qint64>(1, painted_at_.back() - painted_at_.front());
  return 1e3 * static_cast<double>(painted_at_.size() - 1) / static_cast<double>(span);
}

void LiveViewModel::show_freshness() {
  if (playback_.is_frozen || !engine_.snapshot()->tracking || !engine_.state()[part::live] ||
      !since_painted_.isValid() || review_.is_reviewing || kept_)
    return;
  if (playback_.is_paused) {
    banner = tr("Paused. The picture is not live.");
    line = tr("Paused at frame %1, not live").arg(shown_.index);
    is_fresh = QVariant(false);
    return;
  }
  if (!shows_live_) {  // of a former playing, until the first picture of this one comes
    banner = tr("A former picture, not live.");
    line = tr("Frame %1, not live").arg(shown_.index);
    is_fresh = QVariant(false);
    return;
  }
  const double age = last_age_ + static_cast<double>(since_painted_.elapsed()) / 1e3;
  QString text = tr("LIVE   frame %1   age %2 ms   %3 frames/s")
                     .arg(shown_.index)
                     .arg(1e3 * age, 0, 'f', 0)
                     .arg(rate(), 0, 'f', 1);
  const bool draws_refuted = on_screen_.made_from && on_screen_.made_from->draws_refuted;
  const Level level = draws_refuted ? Level::degraded : shown_.level();
  const QString why = QString::fromStdString(scene::validity_text(shown_.validity));
  if (level == Level::withdrawn) text += tr("   NO OVERLAY: %1").arg(why);
  if (level == Level::degraded) text += tr("   OUTLINE ONLY: %1").arg(why);
  const QString remedy = QString::fromStdString(scene::remedy_text(shown_.validity));
  line = remedy.isEmpty() ? text : text + QStringLiteral(". ") + remedy;
  const bool old = age > kFreshSeconds, preparing = drawables_.is_preparing();
  is_fresh = QVariant(level == Level::valid && age < kFreshSeconds && !preparing);
  if (old)
    banner =
        tr("The picture is %1 s old: the overlay does not show where things are now.").arg(age, 0, 'f', 1);
  else
    banner = preparing ? tr("The overlay is being prepared: the picture shows none yet.") : QString();
}

}  // namespace glisson::ui
