// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "glisson/engine/parts/proposals.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "glisson/ui/scene/overlay_painter.h"

namespace glisson::ui {

/// One augmented picture to be drawn.
struct OverlayJob {
  std::shared_ptr<const scene::DrawableModel> model;  ///< null: the picture as it is
  std::shared_ptr<const Points> margin;               ///< anterior margin, CT frame; may be null
  std::shared_ptr<const StereoRig> rig;
  Picture frame;
  OverlayFrame overlay;
  /// When the picture was taken; empty: not live, age is not counted.
  std::optional<std::chrono::steady_clock::time_point> taken;
  scene::OverlayStyle style;
  scene::OverlayInterest interest;
  double frames_per_second = 0.0;    ///< of the live view, to be shown
  bool model_unchecked = false;      ///< nobody has said that the model is right
  engine::LandmarkReview landmarks;  ///< how far their review has come
  bool is_live = false;              ///< of now; else the picture says that it is not
  double source_rate = 30.0;         ///< frames a second of the video, for the recording
  /// Handed back with what became of the job, so that one that is not wanted any more is known.
  int generation = 0;
};

/// What became of a job.
struct PaintedOverlay {
  Picture picture;
  OverlayFrame overlay;
  std::optional<guidance::LesionMeasures> measures;  ///< of the chosen lesion
  double age = 0.0;      ///< seconds from the camera to the end of drawing; 0 when not live
  double draw = 0.0;     ///< seconds that drawing took
  bool is_live = false;  ///< it says so, or does not deny it
  int generation = 0;
};

/// Draws overlays, and records them, on a thread of its own, so that neither the window nor the engine waits
/// for the drawing. Newest wins. Signals come from that thread.
class OverlayWorker : public QObject {
  Q_OBJECT
 public:
  explicit OverlayWorker(QObject* parent = nullptr);
  ~OverlayWorker() override;

  void submit(OverlayJob job);
  /// From now on live pictures are written, each at its own time, at the video's rate: where a frame was not
  /// drawn, the one before stays, as it did on the screen.
  void start_recording(const std::filesystem::path& path);
  /// Closes the file; recording_ended() tells how it went.
  void stop_recording();

 signals:
  void painted(const glisson::ui::PaintedOverlay& painted);
  void failed(const QString& message, int generation);
  /// @param error empty: all is well.
  void recording_ended(const QString& path, int frames, const QString& error);

 private:
  struct Studio;
  void run(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<OverlayJob> job_;
  std::optional<std::filesystem::path> start_;
  bool stop_recording_ = false;
  std::jthread thread_;
};

}  // namespace glisson::ui
