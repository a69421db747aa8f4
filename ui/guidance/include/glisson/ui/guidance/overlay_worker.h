// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "glisson/geometry/camera.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "glisson/ui/guidance/recorder.h"
#include "glisson/ui/scene/overlay_painter.h"

namespace glisson::ui {

/// One augmented picture to be drawn.
struct OverlayJob {
  std::shared_ptr<const scene::DrawableModel> model;  ///< null: the picture as it is
  std::shared_ptr<const Points> margin;               ///< anterior margin, CT frame; may be null
  std::shared_ptr<const StereoRig> rig;
  Picture frame;
  Picture right;  ///< for a recording of the raw views, and PaintedOverlay::right; may be empty
  OverlayFrame overlay;
  bool draws_refuted = false;  ///< what the surfaces contradict is drawn as a proposal, for hands to correct
  /// When the picture was taken; empty: not live, age is not counted.
  std::optional<std::chrono::steady_clock::time_point> taken;
  scene::OverlayStyle style;
  scene::OverlayInterest interest;
  /// What the picture says of the case, and how fast the live view goes. Its age, and whether it stands, are
  /// known when it is drawn.
  scene::OverlayStatus status;
  /// Editions of model and calibration that it is drawn with (engine::Stamp).
  std::uint64_t model_revision = 0, rig_revision = 0;
  bool is_live = false;       ///< of now; else the picture says that it is not
  double source_rate = 30.0;  ///< frames a second of the video, for the recording
  QSize screen;               ///< wanted of PaintedOverlay::screen; empty: none
  bool with_raw = false;      ///< PaintedOverlay::raw_screen is wanted, too
  bool with_right = false;    ///< PaintedOverlay::right likewise
  /// Handed back with what became of the job, so that one that is not wanted any more is known.
  int generation = 0;
};

/// What became of a job.
struct PaintedOverlay {
  Picture picture;
  Picture raw;    ///< as it was taken
  Picture right;  ///< with the overlay; empty: not wanted, or there is none
  QImage screen, raw_screen,
      right_screen;  ///< ready for the screen (scene::screen_image()); null: not wanted
  OverlayFrame overlay;
  std::shared_ptr<const OverlayJob> made_from;       ///< null: there is no picture
  std::optional<guidance::LesionMeasures> measures;  ///< of the chosen lesion
  double age = 0.0;   ///< seconds from the camera to the end of drawing; 0 when not live
  double draw = 0.0;  ///< seconds that drawing took
  std::optional<std::chrono::steady_clock::time_point> taken;  ///< as the job's
  bool is_live = false;                                        ///< it says so, or does not deny it
  int generation = 0;
};

/// Draws overlays on a thread of its own, so that neither the window nor the engine waits for the drawing.
/// Newest wins. What is drawn live is handed to a Recorder while one is wanted. Signals come from these
/// threads.
class OverlayWorker : public QObject {
  Q_OBJECT
 public:
  explicit OverlayWorker(QObject* parent = nullptr);
  ~OverlayWorker() override;

  void submit(OverlayJob job);
  /// From now on live pictures are written, each at its own time, at the video's rate: where a frame was not
  /// drawn, the one before stays, as it did on the screen.
  /// @param options their rate is the video's.
  void start_recording(RecordingOptions options);
  /// Closes the files; recording_ended() tells how it went.
  void stop_recording();

 signals:
  void painted(const glisson::ui::PaintedOverlay& painted);
  void failed(const QString& message, int generation);
  /// So many pictures were shown and not recorded, so far.
  void recording_left_out(int pictures);
  /// At once; what was recorded is kept, as recording_ended() tells then.
  void recording_failed(const QString& error);
  void recording_ended(const glisson::ui::RecordingEnd& end);

 private:
  struct Studio;
  void run(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<OverlayJob> job_;
  std::deque<std::optional<RecordingOptions>> wishes_;  ///< in their order; empty: to stop recording
  std::jthread thread_;
};

}  // namespace glisson::ui
