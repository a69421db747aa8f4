// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProperty>
#include <string>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/again_model.h"
#include "glisson/ui/guidance/correction_model.h"
#include "glisson/ui/guidance/overlay_worker.h"
#include "glisson/ui/guidance/playback_model.h"

namespace glisson::ui {

/// Records the live view: as it is drawn, the raw views, or both, with what was known of each picture beside
/// them, in NAME.frames.jsonl. It may be asked for before the playing begins; it ends with the playing, and
/// when the disk is full, which is said at once. Corrections by hand and registrations that were made
/// meanwhile are written into NAME.mkv.corrections.jsonl.
class RecordingModel : public QObject {
  Q_OBJECT
 public:
  RecordingModel(OverlayWorker& worker, PlaybackModel& playback, CorrectionModel& correction,
                 AgainModel& again, QObject* parent = nullptr);
  /// What was corrected and registered in a recording that still goes on is written beside it.
  ~RecordingModel() override;

  /// Not where files of a former recording would stand beside this one's; `said` names the first then.
  void start(const QString& path);
  /// The file is closed; `said` tells how that went.
  void stop();

  // For widgets to read.
  QProperty<bool> is_recording{false};
  QProperty<bool> is_ending{false};             ///< what was recorded is being brought to its end
  QProperty<Recorded> what{Recorded::overlay};  ///< of the next recording
  QProperty<bool> is_offered;                   ///< starting, or stopping, makes sense
  QProperty<QString> said;
  QProperty<QString> tone;  ///< of what is said, as the style sheet names it: good, warning, error

 private:
  void say(const QString& text, const QString& how);
  /// No more is recorded: what comes from now on is of no concern.
  void begin_end();
  /// A line each: corrections by hand and registrations of this playing.
  std::string lines_now() const;
  static QString beside(const QString& path);
  void take_end(const RecordingEnd& end);
  void tell_end(const RecordingEnd& end);
  static QString left_out_text(int pictures);

  OverlayWorker& worker_;
  CorrectionModel& correction_;
  AgainModel& again_;
  QString path_;       ///< of the recording
  QString recording_;  ///< what is said while it goes on
  std::string lines_;  ///< lines_now() when it ended: the next playing clears what they are made from
  Couplings couplings_;
};

}  // namespace glisson::ui
