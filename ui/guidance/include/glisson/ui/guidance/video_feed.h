// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "glisson/engine/case_state.h"
#include "glisson/engine/parts/video.h"
#include "glisson/patient/picture.h"

namespace glisson::ui {

/// Plays a stereo video at its own rate on a thread of its own, frame by frame into a sink, as a live
/// laparoscope would. Of a live source every frame goes on at once, or never.
class VideoFeed : public QObject {
  Q_OBJECT
 public:
  using Clock = std::chrono::steady_clock;
  /// @param sink called on the feed's thread.
  explicit VideoFeed(std::function<void(StereoFrame)> sink, QObject* parent = nullptr);
  ~VideoFeed() override;

  /// @param first index of the first frame that goes to the sink; a live source starts with its next one, as
  /// 0.
  void start(const engine::VideoSource& source, int first);
  void stop();
  /// While it is paused no frame goes to the sink but those of step().
  void pause(bool on);
  void step();
  /// 1: at the video's own rate; a live source has no other. @pre positive
  void set_speed(double factor) { speed_ = factor; }
  /// Of the video that plays or played last.
  double frames_per_second() const { return rate_; }
  /// When a frame left for the sink, or came from a live source; empty for one long ago or never sent. Any
  /// thread.
  std::optional<Clock::time_point> sent_at(int index) const;

 signals:
  void ended();
  void failed(const QString& message);

 private:
  void play(const std::stop_token& stop, const engine::VideoSource& source, int first);
  /// Whether a live frame goes on now, else never. @pre mutex_ is held.
  bool passes_on();
  /// Until a frame is due. @return false: it is to stop.
  bool wait(std::unique_lock<std::mutex>& lock, const std::stop_token& stop, Clock::time_point& due);

  std::function<void(StereoFrame)> sink_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::map<int, Clock::time_point> sent_;
  std::atomic<double> rate_{30.0}, speed_{1.0};
  bool paused_ = false;
  int steps_ = 0;  ///< frames that a paused feed still sends
  std::jthread thread_;
};

}  // namespace glisson::ui
