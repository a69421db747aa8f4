// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/overlay_worker.h"

#include <list>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/patient/correction.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/scene/picture_image.h"

namespace glisson::ui {

namespace {

/// Paints one camera's pictures.
class Easel {
 public:
  explicit Easel(StereoView view) : view_(view) {}

  /// Of a job without a model: the picture as it is.
  Picture paint(const OverlayJob& job, double age) {
    const bool is_right = view_ == StereoView::right;
    const Picture& frame = is_right ? job.right : job.frame;
    if (!job.model || !job.rig || frame.empty()) return frame;
    const Camera& camera = is_right ? job.rig->right : job.rig->left;
    // The left picture, and its recording, do not end because the right one is of another camera.
    if (is_right && (frame.width != camera.width || frame.height != camera.height)) return {};
    if (!painter_ || model_ != job.model || rig_ != job.rig || margin_ != job.margin) {
      painter_.reset();
      painter_ = std::make_unique<scene::OverlayPainter>(job.model, job.margin ? *job.margin : Points(),
                                                         camera, job.style);
      margin_ = job.margin;
      model_ = job.model;
      rig_ = job.rig;
    }
    painter_->set_style(job.style);
    scene::OverlayStatus status = job.status;
    status.age_seconds = job.is_live ? age : 0.0;
    status.stands = !job.is_live;
    OverlayFrame overlay = is_right ? scene::seen_from_right(job.overlay, *job.rig) : job.overlay;
    if (job.draws_refuted) overlay.validity = Validity::proposed;
    scene::OverlayInterest interest = job.interest;
    if (is_right) interest.pointer.reset();  // a pixel of the other picture
    return painter_->paint(frame, overlay, status, interest);
  }
  std::optional<guidance::LesionMeasures> measures() const {
    return painter_ ? painter_->measures() : std::nullopt;
  }

 private:
  StereoView view_;
  std::unique_ptr<scene::OverlayPainter> painter_;
  std::shared_ptr<const scene::DrawableModel> model_;
  std::shared_ptr<const Points> margin_;
  std::shared_ptr<const StereoRig> rig_;
};

}  // namespace

/// What lives on the worker's thread only: the painters and the recorders.
struct OverlayWorker::Studio {
  explicit Studio(OverlayWorker& worker) : said_by(worker) {}

  OverlayWorker& said_by;
  Easel left{StereoView::left}, right{StereoView::right};
  std::optional<RecordingOptions> wanted;        ///< until the first picture tells its rate
  std::unique_ptr<Recorder> recorder;            ///< of what is drawn now
  std::list<std::unique_ptr<Recorder>> closing;  ///< they write on

  void start(RecordingOptions options) {
    stop();
    wanted = std::move(options);
  }

  void record(const PaintedOverlay& painted, const OverlayJob& job) {
    if (wanted) {
      wanted->frames_per_second = job.source_rate;
      recorder = std::make_unique<Recorder>(*std::exchange(wanted, {}), listener());
    }
    if (!recorder) return;
    recorder->add({painted.picture, job.frame, job.right, job.overlay, painted.age,
                   job.model ? job.model->model : nullptr});
  }

  Recorder::Listener listener() {
    return {[this](int pictures) { emit said_by.recording_left_out(pictures); },
            [&worker = said_by](const QString& error) { emit worker.recording_failed(error); },
            [&worker = said_by](const RecordingEnd& end) { emit worker.recording_ended(end); }};
  }

  /// @param why it ends before it should; empty: somebody wishes so.
  void stop(const QString& why = {}) {
    closing.remove_if([](const std::unique_ptr<Recorder>& one) { return one->is_done(); });
    if (wanted) emit said_by.recording_ended({QString::fromStdString(wanted->path.string()), 0, 0, 0, why});
    wanted.reset();
    if (!recorder) return;
    if (!why.isEmpty()) emit said_by.recording_failed(why);
    recorder->finish(why);
    closing.push_back(std::move(recorder));
  }

  void grant(std::optional<RecordingOptions> wish) { wish ? start(std::move(*wish)) : stop(); }
};

OverlayWorker::OverlayWorker(QObject* parent) : QObject(parent) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

OverlayWorker::~OverlayWorker() {
  thread_.request_stop();
  thread_.join();
}

void OverlayWorker::submit(OverlayJob job) {
  {
    const std::lock_guard lock(mutex_);
    job_ = std::move(job);
  }
  changed_.notify_one();
}

void OverlayWorker::start_recording(RecordingOptions options) {
  {
    const std::lock_guard lock(mutex_);
    wishes_.emplace_back(std::move(options));
  }
  changed_.notify_one();
}

void OverlayWorker::stop_recording() {
  {
    const std::lock_guard lock(mutex_);
    wishes_.emplace_back();
  }
  changed_.notify_one();
}

void OverlayWorker::run(const std::stop_token& stop) {
  Studio studio(*this);
  while (true) {
    std::optional<OverlayJob> wanted;
    std::deque<std::optional<RecordingOptions>> wishes;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stop, [this] { return job_ || !wishes_.empty(); });
      if (stop.stop_requested()) break;
      std::swap(wanted, job_);
      std::swap(wishes, wishes_);
    }
    for (auto& wish : wishes) studio.grant(std::move(wish));
    if (!wanted || wanted->frame.empty()) continue;
    const auto job = std::make_shared<const OverlayJob>(std::move(*wanted));
    const auto begin = std::chrono::steady_clock::now();
    const auto seconds_since = [](std::chrono::steady_clock::time_point then) {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
    };
    try {
      PaintedOverlay done;
      done.picture = studio.left.paint(*job, job->taken ? seconds_since(*job->taken) : 0.0);
      if (job->with_right)
        done.right = studio.right.paint(*job, job->taken ? seconds_since(*job->taken) : 0.0);
      done.raw = job->frame;
      done.screen = scene::screen_image(done.picture, job->screen);
      if (job->with_raw) done.raw_screen = scene::screen_image(done.raw, job->screen);
      if (job->with_right) done.right_screen = scene::screen_image(done.right, job->screen);
      done.overlay = job->overlay;
      done.made_from = job;
      if (job->model && job->rig) done.measures = studio.left.measures();
      done.taken = job->taken;
      done.age = job->taken ? seconds_since(*job->taken) : 0.0;
      done.draw = seconds_since(begin);
      done.is_live = job->is_live;
      done.generation = job->generation;
      emit painted(done);
      if (job->taken) studio.record(done, *job);
    } catch (const std::exception& problem) {
      const QString why = error_text(problem.what());
      emit failed(why, job->generation);
      if (job->taken) studio.stop(why);  // a still picture is in no recording
    }
  }
  studio.stop();
}

}  // namespace glisson::ui
