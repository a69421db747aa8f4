// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/moments_model.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/time_text.h"
#include "glisson/engine/commands/keep_moment.h"
#include "glisson/engine/commands/remove_moment.h"
#include "glisson/engine/commands/rename_moment.h"
#include "glisson/engine/parts/keeping.h"
#include "glisson/engine/parts/moments.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/stereo/png.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/guidance/moment_texts.h"
#include "glisson/ui/scene/picture_image.h"

namespace glisson::ui {
namespace {

constexpr std::size_t kMostWaiting = 16;  ///< besides thumbnails
constexpr int kThumbnailWidth = 96, kThumbnailHeight = 60;

/// All but the pictures and the number.
engine::KeptMoment moment_of(const PaintedOverlay& painted) {
  const OverlayJob& job = *painted.made_from;
  engine::KeptMoment moment;
  moment.kept_at = utc_time_text("%Y-%m-%dT%H:%M:%SZ");
  moment.overlay = painted.overlay;
  moment.chosen = job.interest.lesion;
  moment.measures = painted.measures;
  moment.place = job.interest.place;
  if (job.margin) moment.margin = *job.margin;
  moment.model_unchecked = job.status.model_unchecked;
  moment.landmarks_open = job.status.landmarks_open;
  moment.landmarks_from_statistics = job.status.landmarks_from_statistics;
  moment.model_revision = job.model_revision;
  moment.rig_revision = job.rig_revision;
  const PointsIn<CtFrame>& at_rest = job.model->model->mesh.vertices;
  if (moment.overlay.nodes_in_camera.rows() == at_rest.rows())
    moment.camera_from_model = pose_of(at_rest, moment.overlay);
  else
    moment.overlay.nodes_in_camera.resize(0, 3);  // nothing of the model was drawn
  return moment;
}

}  // namespace

MomentsModel::MomentsModel(EngineBridge& engine, PlaybackModel& playback, ReviewModel& review,
                           LiveViewModel& live, QObject* parent)
    : QObject(parent), engine_(engine), playback_(playback), review_(review), live_(live) {
  connect(&engine_, &EngineBridge::case_changed, this, &MomentsModel::read_case);
  connect(&engine_, &EngineBridge::finished, this, &MomentsModel::read_outcome);
  connect(&live_, &LiveViewModel::picture_changed, this, [this] { obstacle = why_not(); });
  connect(&live_, &LiveViewModel::kept_put_away, this, [this] {
    wanted_ = shown = 0;
    obstacle = why_not();
  });
  connect(&review_, &ReviewModel::live_wanted, this, [this] { live_.show_kept({}); });
  couplings_.add(review_.is_reviewing, [this](bool) { obstacle = why_not(); });
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  read_case();
}

MomentsModel::~MomentsModel() {
  thread_.request_stop();
  thread_.join();
}

void MomentsModel::run(const std::stop_token& stop) {
  constexpr int kGiveWay = 10;  // on Linux of this thread alone: what is live goes first
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kGiveWay);
  stereo::PictureReader reader;
  while (true) {
    Work work;
    {
      std::unique_lock lock(mutex_);
      if (!wakes_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
      work = std::move(waiting_.front());
      waiting_.pop_front();
    }
    work(reader);
  }
}

bool MomentsModel::do_beside(Work work) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= kMostWaiting + engine::kMostMoments) return false;
    waiting_.push_back(std::move(work));
  }
  wakes_.notify_one();
  return true;
}

void MomentsModel::do_here(std::function<void()> work) {
  QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection);
}

void MomentsModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

QString MomentsModel::why_not() const {
  if (live_.shows_kept())
    return tr("A kept moment is on the screen. Go back to live (Esc), then keep another one.");
  if (review_.is_reviewing)
    return tr(
        "A former frame is on the screen, of which the raw pictures are not there any more. Go back to "
        "live (End).");
  const PaintedOverlay& painted = live_.on_screen();
  const bool is_followed = playback_.is_tracking || playback_.is_frozen;
  if (!is_followed || !painted.made_from || painted.made_from->right.empty()) {
    const QString first = PlaybackModel::requirement(*engine_.snapshot());
    return first.isEmpty() ? tr("Nothing is followed: start tracking, then keep a moment.") : first;
  }
  if (!painted.made_from->model || !painted.made_from->rig)
    return tr("The overlay is being prepared: there is nothing to keep yet.");
  return {};
}

void MomentsModel::keep() {
  obstacle = why_not();
  if (!obstacle.value().isEmpty()) return say(obstacle, QStringLiteral("warning"));
  // What is on the screen now, whatever is followed while it is written.
  const auto job = live_.on_screen().made_from;
  auto moment = std::make_shared<engine::KeptMoment>(moment_of(live_.on_screen()));
  const std::uint64_t of = engine_.snapshot()->case_number;
  const bool is_taken = do_beside([this, job, moment, of](stereo::PictureReader&) {
    QString problem;
    try {
      moment->left_png = std::make_shared<const std::string>(stereo::png_of(job->frame));
      moment->right_png = std::make_shared<const std::string>(stereo::png_of(job->right));
    } catch (const std::exception& failure) {
      problem = error_text(failure.what());
    }
    do_here([this, moment, of, problem] {
      if (!problem.isEmpty()) return say(problem, QStringLiteral("error"));
      if (engine_.snapshot()->case_number == of) engine_.post(engine::KeepMoment{moment});
    });
  });
  is_taken ? say(tr("Frame %1 is being kept.").arg(moment->overlay.index))
           : say(tr("Too many moments are being kept at once. Wait, then keep this one again."),
                 QStringLiteral("warning"));
}

void MomentsModel::read_outcome(const engine::Outcome& outcome) {
  const bool is_ours = outcome.traits.writes == engine::Parts{part::moments};
  if (!is_ours || outcome.status == engine::Status::cancelled) return;
  if (outcome.status == engine::Status::failed)
    return say(error_text(outcome.error), QStringLiteral("error"));
  const auto number = outcome.figures.find("moment");
  if (number == outcome.figures.end()) return;
  const QString kept = tr("Moment %1 is kept.").arg(static_cast<int>(number->second));
  const auto& keeping = engine_.state()[part::keeping];
  if (keeping && !keeping->lock)
    say(kept + QLatin1Char(' ') +
            tr("This case is open for reading: save it under another name, or the moment is lost with the "
               "window."),
        QStringLiteral("warning"));
  else
    say(kept);
}

void MomentsModel::read_case() {
  if (const std::uint64_t number = engine_.snapshot()->case_number; number != case_number) {
    case_number = number;
    former_.clear();
    can_undo = false;
    say({});
  }
  obstacle = why_not();
  if (kept_ == engine_.state()[part::moments]) return;
  kept_ = engine_.state()[part::moments];
  if (shown != 0) {
    const auto now = engine::moment_of(engine_.state(), shown);
    if (!now)
      go_live();
    else if (now != shown_)
      show(shown);  // by its new title
  }
  make_thumbnails();
  make_rows();
}

void MomentsModel::make_rows() {
  std::vector<MomentRow> made;
  if (kept_)
    for (const auto& moment : kept_->moments)
      made.push_back({moment->number, QString::fromStdString(moment->title), moment_place(*moment),
                      moment_level(*moment), moment->overlay.level(), thumbnails_[moment->left_png]});
  std::reverse(made.begin(), made.end());  // the newest first
  rows = std::move(made);
}

void MomentsModel::make_thumbnails() {
  std::map<std::shared_ptr<const std::string>, QImage> needed;
  if (kept_)
    for (const auto& moment : kept_->moments) {
      const auto& picture = moment->left_png;
      const auto there = thumbnails_.find(picture);
      needed[picture] = there == thumbnails_.end() ? QImage() : there->second;
      if (there != thumbnails_.end()) continue;
      do_beside([this, picture](stereo::PictureReader& reader) {
        QImage small;
        try {
          const Picture whole = reader.decode(*picture, "PNG");
          small =
              scene::view_as_image(whole)
                  .scaled(kThumbnailWidth, kThumbnailHeight, Qt::KeepAspectRatio, Qt::SmoothTransformation)
                  .convertToFormat(QImage::Format_RGB32);
        } catch (const std::exception&) {
          return;  // told when the moment is to be shown
        }
        do_here([this, picture, small] {
          const auto there = thumbnails_.find(picture);
          if (there == thumbnails_.end()) return;
          there->second = small;
          make_rows();
        });
      });
    }
  thumbnails_ = std::move(needed);
}

void MomentsModel::show(int number) {
  const auto moment = engine::moment_of(engine_.state(), number);
  if (!moment) return;
  wanted_ = number;
  const std::uint64_t of = engine_.snapshot()->case_number;
  do_beside([this, moment, of](stereo::PictureReader& reader) {
    LiveViewModel::Kept kept{moment, {}, {}};
    QString problem;
    try {
      kept.left = reader.decode(*moment->left_png, "moment " + std::to_string(moment->number));
      kept.right = reader.decode(*moment->right_png, "moment " + std::to_string(moment->number));
    } catch (const std::exception& failure) {
      problem = error_text(failure.what());
    }
    do_here([this, kept, problem, of] {
      const int read = kept.moment->number;
      const bool is_there =
          engine_.snapshot()->case_number == of && engine::moment_of(engine_.state(), read) != nullptr;
      if (read != wanted_ || !is_there) return;
      wanted_ = 0;
      if (!problem.isEmpty()) return say(problem, QStringLiteral("error"));
      if (review_.is_reviewing && review_.runs) review_.toggle();  // it would go on over the moment
      say({});
      live_.show_kept(kept);
      shown_ = kept.moment;
      shown = read;
      obstacle = why_not();
    });
  });
}

void MomentsModel::go_live() {
  wanted_ = 0;
  if (!live_.shows_kept()) return;
  live_.show_kept({});
  if (review_.is_reviewing) review_.seek(review_.position);  // what it stood over
}

void MomentsModel::rename(int number, const QString& title) {
  const auto moment = engine::moment_of(engine_.state(), number);
  const std::string wanted = title.trimmed().toStdString();
  if (!moment || moment->title == wanted) return;
  // Its number may have changed by then, or be another's; its pictures are its own.
  former_.emplace_back([this, number, title = moment->title, picture = moment->left_png] {
    const auto& kept = engine_.state()[part::moments];
    if (kept)
      for (const auto& one : kept->moments)
        if (one->left_png == picture) return engine::Command(engine::RenameMoment{one->number, title});
    return engine::Command(engine::RenameMoment{number, title});
  });
  can_undo = true;
  engine_.post(engine::RenameMoment{number, wanted});
}

void MomentsModel::remove(int number) {
  const auto moment = engine::moment_of(engine_.state(), number);
  if (!moment) return;
  former_.emplace_back([this, moment] { return keep_again(moment); });
  can_undo = true;
  engine_.post(engine::RemoveMoment{number});
  say(tr("Moment %1 is deleted. Undo brings it back.").arg(number));
}

engine::Command MomentsModel::keep_again(const std::shared_ptr<const engine::KeptMoment>& moment) const {
  // When the last one is deleted numbers begin anew: its own may be another's by now.
  if (!engine::moment_of(engine_.state(), moment->number)) return engine::KeepMoment{moment};
  auto again = std::make_shared<engine::KeptMoment>(*moment);
  again->number = 0;
  return engine::KeepMoment{std::move(again)};
}

void MomentsModel::undo() {
  if (former_.empty()) return;
  engine_.post(former_.back()());
  former_.pop_back();
  can_undo = !former_.empty();
}

}  // namespace glisson::ui
