// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProperty>
#include <memory>

#include "glisson/engine/commands/start_tracking.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/guidance/video_feed.h"

namespace glisson::ui {

/// Plays the case's video while it is tracked. When the playing ends by itself or by the person, its last
/// picture stays, marked ("frozen"), as long as its registration is the case's.
class PlaybackModel : public QObject {
  Q_OBJECT
 public:
  explicit PlaybackModel(EngineBridge& engine, QObject* parent = nullptr);

  /// What starts it: the case's video is followed, with the person's own mask network, if any.
  engine::StartTracking command() const;
  /// The step to do before tracking; empty: it can start.
  static QString requirement(const engine::Snapshot& now);

  /// The engine has begun to track, or has not: the video plays from the frame after the registered one.
  void begin(const engine::Outcome& outcome);
  /// The person has seen enough.
  void stop();
  /// Frames wait (those of a live source pass by), or come again; tracking stays as it is. Nothing happens
  /// unless it plays.
  void pause(bool on);
  /// One frame more of a paused video.
  void step() { feed_.step(); }
  void set_speed(double factor) { feed_.set_speed(factor); }
  const VideoFeed& feed() const { return feed_; }
  /// Of the case whose video it is (engine::Snapshot).
  std::uint64_t case_number() const { return engine_.snapshot()->case_number; }

  // For widgets to read.
  QProperty<bool> is_tracking;  ///< the engine follows frames
  QProperty<bool> is_frozen;
  QProperty<QString> frozen_why;  ///< said above the last picture
  QProperty<bool> is_paused{false};
  QProperty<bool> is_playing;   ///< tracking, and not frozen: what the feed says concerns it
  QProperty<QString> obstacle;  ///< why tracking cannot start now
  // For widgets and other models to set.
  QProperty<QString> mask_network;  ///< file; empty: none
  QProperty<bool> repeats{false};   ///< at the video's end, track again from the registered frame

 signals:
  /// The video plays from now on.
  void begun();
  /// The properties are those of the present case.
  void case_read();
  /// The video is over and repeats.
  void start_wanted();

 private:
  void read_case();
  void freeze(const QString& why);
  void unfreeze();

  EngineBridge& engine_;
  VideoFeed feed_;
  QProperty<QString> requirement_;
  bool starts_again_ = false;
  std::shared_ptr<const Registration> frozen_registration_;
};

}  // namespace glisson::ui
