// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <vector>

#include "glisson/engine/engine.h"

namespace glisson::ui {

/// A command that waits or runs.
struct Task {
  engine::CommandId id = 0;
  engine::CommandTraits traits;  ///< of the command
  double fraction = 0.0;
  std::string stage;  ///< code; empty while it waits
};

/// The window's only door to the engine. Whatever the engine's threads announce becomes one queued call on
/// the GUI thread; nothing here waits. Signals are emitted on the GUI thread.
class EngineBridge : public QObject {
  Q_OBJECT
 public:
  /// @param options `wake` is taken over by the bridge.
  explicit EngineBridge(engine::Engine::Options options = {}, QObject* parent = nullptr);
  ~EngineBridge() override;

  /// What a person did to the case that snapshot() shows: it ends as cancelled where another one takes its
  /// place first (engine::Engine::post). Files are read into whatever case there is by then.
  engine::CommandId post(engine::Command command);
  void cancel(engine::CommandId id);
  /// Newest wins. May be called from any thread.
  void submit_frame(StereoFrame frame);
  /// See engine::Engine::submit_pull.
  void submit_pull(const std::optional<engine::TrialPull>& pull);

  /// The one last announced; never null.
  const std::shared_ptr<const engine::Snapshot>& snapshot() const { return snapshot_; }
  const engine::CaseState& state() const { return snapshot_->state; }
  const std::vector<Task>& tasks() const { return tasks_; }
  bool is_busy(engine::CommandId id) const;

 signals:
  /// A part of the case, its staleness or tracking changed (not: a live frame).
  void case_changed();
  void live_changed();
  /// A step of the load trial, its start or its end.
  void trial_changed();
  /// The liver's contour while it is segmented.
  void evolving_changed();
  /// Before the engine has it: what is posted now comes first.
  void about_to_post(const glisson::engine::CommandTraits& work);
  void tasks_changed();
  void finished(const glisson::engine::Outcome& outcome);

 private:
  void deliver();
  void take(const engine::Event& event);

  std::shared_ptr<const engine::Snapshot> snapshot_;
  std::vector<Task> tasks_;
  std::atomic<bool> call_is_queued_{false};
  std::unique_ptr<engine::Engine> engine_;
};

}  // namespace glisson::ui
