// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "glisson/ui/common/engine_bridge.h"

class QMessageBox;

namespace glisson::ui {

/// Between what a person wishes (close, open, save) and its being done while work runs: says which work it
/// is and what becomes of its result, and lets the person wait for it, stop it, or take the wish back. One
/// wish at a time, the newest.
class RunningWork : public QObject {
  Q_OBJECT
 public:
  /// A wish, in the words of its question.
  struct Wish {
    QString title;
    QString told;               ///< what becomes of the result of the work
    QString wait, stop, leave;  ///< the three buttons
    QString afterwards;         ///< "then the window closes": told while it is waited
    std::function<bool(const engine::CommandTraits&)> concerns;  ///< of work that runs
    std::function<void()> then;
  };
  static Wish closing(std::function<void()> then);
  static Wish saving(std::function<void()> then);
  /// @param traits of what opens it: work is concerned whose result would be replaced.
  static Wish opening(const engine::CommandTraits& traits, std::function<void()> then);

  /// @param window what the question belongs to.
  RunningWork(EngineBridge& engine, QWidget* window);

  bool concerns(const Wish& wish) const { return !work_of(wish).empty(); }
  /// Does what is wished: at once where no work is concerned, else when the person has said what becomes of
  /// it. Where work that is waited for fails or is cancelled the wish is dropped: first the person reads why.
  void before(Wish wish);

 signals:
  /// What is done when the work has ended; empty: nothing waits for it.
  void waits(const QString& afterwards);

 private:
  std::vector<Task> work_of(const Wish& wish) const;
  void ask(const std::vector<Task>& work);
  void wait_for_work();
  void stop_work();
  void take(const engine::Outcome& outcome);
  /// What the question says when the work has ended before it was answered.
  void tell_end();
  void take_back();
  void proceed();

  EngineBridge& engine_;
  QWidget* window_;
  std::optional<Wish> wish_;
  QPointer<QMessageBox> question_;
  std::set<engine::CommandId> awaited_;
  bool stops_ = false;
};

}  // namespace glisson::ui
