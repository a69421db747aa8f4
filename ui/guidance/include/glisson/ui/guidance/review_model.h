// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProperty>
#include <QTimer>
#include <memory>
#include <vector>

#include "glisson/engine/parts/model.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/patient_model.h"
#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/moment_store.h"
#include "glisson/ui/guidance/playback_model.h"

namespace glisson::ui {

/// From this frame on the overlay's level is another one.
struct LevelMark {
  int index = 0;
  Level level = Level::withdrawn;
  bool operator==(const LevelMark&) const = default;
};

/// The way through a recorded video: play, pause, step, seek, speed, loop. Frames can only be followed one
/// after the other, so forward of what was followed there is no seeking; what was followed is looked at again
/// as it was. A new playing, another registration and another case forget it.
class ReviewModel : public QObject {
  Q_OBJECT
 public:
  /// Both outlive this.
  ReviewModel(EngineBridge& engine, PlaybackModel& playback, QObject* parent = nullptr);

  /// Plays or pauses what is on the screen: the live video, or what was followed.
  void toggle();
  /// Pauses, and shows the frame before or after the one on the screen; at the end of what was followed the
  /// next one is followed.
  void step(int by);
  /// Shows the frame nearest to this one among those that were followed.
  void seek(int index);
  /// Back to the live video, which goes on.
  void go_live();
  void set_speed(double factor);

  // For widgets to read.
  QProperty<bool> is_offered{false};    ///< there is something to go through
  QProperty<bool> is_reviewing{false};  ///< a former frame is on the screen
  QProperty<bool> runs{false};          ///< the live video, or the look back, goes on by itself
  QProperty<int> first{0}, last{0};     ///< frames that can be looked at
  QProperty<int> position{0};           ///< of the frame on the screen
  QProperty<std::vector<LevelMark>> marks;
  // For widgets to set.
  QProperty<bool> loops{false};  ///< the look back begins again at its end

 signals:
  /// A former frame is to be shown.
  void shown(const glisson::ui::Moment& moment);
  /// Somebody wants the live video, whatever is on the screen.
  void live_wanted();
  /// The former frame is not to be shown any more.
  void ended();

 private:
  void read_case();
  void take_live();
  void read_store();
  void show_at(std::size_t place);
  void advance();
  void leave();
  std::size_t place_of(int index) const;
  void say_runs();

  EngineBridge& engine_;
  PlaybackModel& playback_;
  MomentStore store_;
  std::vector<MomentStore::Entry> entries_;
  std::shared_ptr<const Registration> registration_;
  std::shared_ptr<const StereoRig> rig_;
  std::shared_ptr<const model::BuiltModel> model_;
  std::shared_ptr<const Landmarks> landmarks_;
  QTimer timer_;
  double speed_ = 1.0;
  Couplings couplings_;
};

}  // namespace glisson::ui
