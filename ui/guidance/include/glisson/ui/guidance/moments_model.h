// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QProperty>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/live_view_model.h"
#include "glisson/ui/guidance/playback_model.h"
#include "glisson/ui/guidance/review_model.h"

namespace glisson::engine {
struct KeptMoment;
struct KeptMoments;
}  // namespace glisson::engine
namespace glisson::stereo {
class PictureReader;
}

namespace glisson::ui {

/// A kept moment in the list.
struct MomentRow {
  int number = 0;
  QString title;  ///< a person's; may be empty
  QString time, state;
  Level level = Level::withdrawn;
  QImage thumbnail;  ///< null: not made yet, or the picture cannot be read
  bool operator==(const MomentRow&) const = default;
};

/// Keeps what is on the screen in the case, and shows what was kept. Pictures are written and read on a
/// thread of its own, so that the live view waits for nothing.
class MomentsModel : public QObject {
  Q_OBJECT
 public:
  /// All outlive this.
  MomentsModel(EngineBridge& engine, PlaybackModel& playback, ReviewModel& review, LiveViewModel& live,
               QObject* parent = nullptr);
  ~MomentsModel() override;

  /// Keeps the frame whose overlay is on the screen; where that cannot be, `said` tells why.
  void keep();
  /// Shows it instead of the live view, which goes on.
  void show(int number);
  /// Back from a kept moment to what was shown before.
  void go_live();
  void rename(int number, const QString& title);
  void remove(int number);
  /// Takes the last renaming or deletion of this case back.
  void undo();

  // For widgets to read.
  QProperty<std::uint64_t> case_number{0};  ///< whose moments they are (engine::Snapshot)
  QProperty<std::vector<MomentRow>> rows;
  QProperty<int> shown{0};      ///< number of the moment on the screen; 0: none
  QProperty<QString> obstacle;  ///< why none can be kept now; empty: one can
  QProperty<bool> can_undo{false};
  QProperty<QString> said, tone;  ///< as the style sheet names it: warning, error

 private:
  using Work = std::function<void(stereo::PictureReader&)>;
  void run(const std::stop_token& stop);
  /// @return false: so much waits already that this one is not taken.
  bool do_beside(Work work);
  /// Does it on the window's thread, as long as this lives.
  void do_here(std::function<void()> work);
  void read_case();
  void make_rows();
  void make_thumbnails();
  void read_outcome(const engine::Outcome& outcome);
  /// What takes its deletion back, as the case stands then.
  engine::Command keep_again(const std::shared_ptr<const engine::KeptMoment>& moment) const;
  QString why_not() const;
  void say(const QString& text, const QString& how = {});

  EngineBridge& engine_;
  PlaybackModel& playback_;
  ReviewModel& review_;
  LiveViewModel& live_;
  Couplings couplings_;
  std::shared_ptr<const engine::KeptMoments> kept_;
  std::map<std::shared_ptr<const std::string>, QImage> thumbnails_;  ///< by picture; null: being made
  std::vector<std::function<engine::Command()>> former_;             ///< what takes each step back
  std::shared_ptr<const engine::KeptMoment> shown_;  ///< on the screen, while `shown` is not 0
  int wanted_ = 0;                                   ///< that is being read, to be shown; 0: none
  std::mutex mutex_;
  std::condition_variable_any wakes_;
  std::deque<Work> waiting_;
  std::jthread thread_;
};

}  // namespace glisson::ui
