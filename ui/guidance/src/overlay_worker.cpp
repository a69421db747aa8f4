// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/overlay_worker.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/error_texts.h"

namespace glisson::ui {
namespace {

constexpr double kLongestGap = 2.0;  ///< seconds without a picture that a recording keeps

}  // namespace

/// What lives on the worker's thread only: the painter and the recorder.
struct OverlayWorker::Studio {
  std::unique_ptr<scene::OverlayPainter> painter;
  std::shared_ptr<const scene::DrawableModel> model;
  std::shared_ptr<const Points> margin;
  std::shared_ptr<const StereoRig> rig;
  std::optional<std::filesystem::path> wanted;
  std::unique_ptr<stereo::VideoWriter> writer;
  int written = 0;
  double rate = 30.0, begun = 0.0;  ///< frames a second; the video's time of the first frame
  Picture last;

  Picture paint(const OverlayJob& job, double age) {
    if (!job.model || !job.rig) return job.frame;
    if (!painter || model != job.model || rig != job.rig || margin != job.margin) {
      painter.reset();
      painter = std::make_unique<scene::OverlayPainter>(job.model, job.margin ? *job.margin : Points(),
                                                        job.rig->left, job.style);
      margin = job.margin;
      model = job.model;
      rig = job.rig;
    }
    painter->set_style(job.style);
    return painter->paint(job.frame, job.overlay,
                          {job.is_live ? age : 0.0, job.frames_per_second, job.model_unchecked, !job.is_live,
                           job.landmarks.is_open, job.landmarks.from_statistics},
                          job.interest);
  }

  std::optional<guidance::LesionMeasures> measures() const {
    return painter ? painter->measures() : std::nullopt;
  }

  /// A frame of the file stands for its own moment of the video, so that the recording runs as fast as what
  /// was filmed, however many frames were drawn.
  void record(const Picture& picture, const OverlayJob& job) {
    if (!wanted) return;
    if (!writer) {
      rate = job.source_rate;
      begun = job.overlay.seconds;
      writer = std::make_unique<stereo::VideoWriter>(*wanted, picture.width, picture.height, rate);
    }
    const long place = std::lround((job.overlay.seconds - begun) * rate);
    if (place < written) return;  // this moment is written already
    const long longest_gap = std::lround(kLongestGap * rate);
    if (place - written <= longest_gap)
      while (written < place) write(last);
    else
      begun += static_cast<double>(place - written) / rate;  // a jump in the source is no pause
    write(picture);
    last = picture;
  }

  void write(const Picture& picture) {
    writer->write(picture);
    ++written;
  }

  /// @return the error, if any.
  QString close() {
    QString error;
    try {
      if (writer) writer->close();
    } catch (const Error& problem) {
      error = error_text(problem.what());
    }
    writer.reset();
    wanted.reset();
    return error;
  }
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

void OverlayWorker::start_recording(const std::filesystem::path& path) {
  {
    const std::lock_guard lock(mutex_);
    start_ = path;
  }
  changed_.notify_one();
}

void OverlayWorker::stop_recording() {
  {
    const std::lock_guard lock(mutex_);
    stop_recording_ = true;
  }
  changed_.notify_one();
}

void OverlayWorker::run(const std::stop_token& stop) {
  Studio studio;
  const auto end_recording = [&](const QString& problem) {
    if (!studio.wanted) return;
    const QString path = QString::fromStdString(studio.wanted->string());
    const int frames = studio.written;
    const QString error = studio.close();
    emit recording_ended(path, frames, problem.isEmpty() ? error : problem);
  };
  while (true) {
    std::optional<OverlayJob> job;
    bool finish = false;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stop, [this] { return job_ || start_ || stop_recording_; });
      if (stop.stop_requested()) break;
      std::swap(job, job_);
      if (start_) {
        studio.wanted = start_;
        studio.written = 0;
        start_.reset();
      }
      finish = std::exchange(stop_recording_, false);
    }
    if (finish) end_recording({});
    if (!job || job->frame.empty()) continue;
    const auto begin = std::chrono::steady_clock::now();
    const auto seconds_since = [](std::chrono::steady_clock::time_point then) {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
    };
    try {
      const Picture picture = studio.paint(*job, job->taken ? seconds_since(*job->taken) : 0.0);
      emit painted({picture, job->overlay, studio.measures(), job->taken ? seconds_since(*job->taken) : 0.0,
                    seconds_since(begin), job->is_live, job->generation});
      if (job->taken) studio.record(picture, *job);
    } catch (const std::exception& problem) {
      const QString message = error_text(problem.what());
      emit failed(message, job->generation);
      end_recording(message);
    }
  }
  end_recording({});
}

}  // namespace glisson::ui
