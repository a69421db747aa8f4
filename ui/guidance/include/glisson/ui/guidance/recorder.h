// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "glisson/geometry/mesh.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "glisson/stereo/paced_writer.h"

namespace glisson::ui {

/// What of the live view is recorded.
enum class Recorded {
  overlay,  ///< as it is drawn
  raw,      ///< both views side by side as they came, which can be followed again
  both
};

struct RecordingOptions {
  std::filesystem::path path;  ///< .mkv: the overlay, or the raw views where they alone are recorded
  Recorded what = Recorded::overlay;
  double frames_per_second = 30.0;
  std::function<std::string(Validity)> remedy;   ///< in words, for the record; may be absent
  stereo::FreeSpace space = stereo::free_space;  ///< for tests
};

/// One live picture for a recording.
struct RecordedFrame {
  Picture drawn, left, right;
  OverlayFrame overlay;
  double age = 0.0;  ///< seconds from the camera to the drawn picture
  std::shared_ptr<const PatientModel> model;
};

/// How a recording went.
struct RecordingEnd {
  QString path;
  int frames = 0;    ///< of the film, repeated ones included
  int repeated = 0;  ///< frames that show the picture before once more; beside the film they have no line
  int left_out = 0;  ///< pictures that were shown and not recorded: the writing could not keep up
  QString error;     ///< empty: all is well; else `frames` are there and play
};

/// Writes the live view on a thread of its own: the films, and beside them NAME.frames.jsonl, a line a
/// picture (see overlay_record.h), from which the film can be drawn again. Whoever hands over a picture never
/// waits: where too many wait already it is left out, and counted.
class Recorder {
 public:
  struct Listener {
    std::function<void(int left_out)> left_out;          ///< one more; from the thread that called add()
    std::function<void(const QString& error)> trouble;   ///< at once; the end follows
    std::function<void(const RecordingEnd& end)> ended;  ///< all is in its place, or lost
  };
  /// Of both films: where the raw views stand, beside the overlay's path.
  static std::filesystem::path raw_path(const std::filesystem::path& path);
  static std::filesystem::path lines_path(const std::filesystem::path& path);

  /// @param listener but for left_out called on the recorder's thread.
  Recorder(RecordingOptions options, Listener listener);
  /// Waits until all is written.
  ~Recorder();
  /// Any one thread.
  void add(RecordedFrame frame);
  /// No more come; `ended` is called when all is written.
  /// @param why the recording ends before it should; empty: it is as long as it was to be.
  void finish(QString why = {});
  /// `ended` has been called.
  bool is_done() const;

 private:
  class Reel;
  void run();
  void write(Reel& reel);

  RecordingOptions options_;
  Listener listener_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<RecordedFrame> waiting_;
  bool finishing_ = false, failed_ = false, done_ = false;
  QString why_;  ///< it was finished early; empty: it was not
  int left_out_ = 0;
  std::thread thread_;
};

}  // namespace glisson::ui
