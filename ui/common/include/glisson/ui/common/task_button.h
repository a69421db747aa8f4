// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "glisson/ui/common/engine_bridge.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace glisson::ui {

/// A button that posts one command, and while that waits or runs its progress with a way to cancel it. Below,
/// how it ended: time, or the error with its remedy.
class TaskButton : public QWidget {
  Q_OBJECT
 public:
  /// @param make is asked when the button is pressed; empty: nothing is posted.
  TaskButton(EngineBridge& engine, const QString& text, std::function<std::optional<engine::Command>()> make,
             QWidget* parent = nullptr);

  /// Keeps room for the progress, for what is in the way and for how it ended, a line each, so that nothing
  /// below moves when it is said.
  void reserve_lines();
  /// Why the button cannot be pressed now; empty: it can.
  void set_obstacle(const QString& obstacle);
  /// From now on what stands in the way of a command like this one (engine::obstacle) is told, too, and comes
  /// first.
  void watch(engine::Command command);
  /// As pressing the button, where it can be pressed.
  void trigger();
  bool is_running() const { return running_.has_value(); }
  QPushButton* button() const { return button_; }
  QToolButton* cancel_button() const { return cancel_; }

 signals:
  void done(const glisson::engine::Outcome& outcome);

 private:
  void start();
  void ask();
  QString obstacle() const { return asked_.isEmpty() ? obstacle_ : asked_; }
  void show_tasks();
  void show_outcome(const engine::Outcome& outcome);
  void show_state();

  EngineBridge& engine_;
  std::function<std::optional<engine::Command>()> make_;
  std::optional<engine::CommandId> running_;
  std::optional<engine::Command> watched_;
  QString asked_, obstacle_;  ///< what the engine says; what set_obstacle() has said
  QPushButton* button_;
  bool is_reserved_ = false;
  QWidget* below_;  ///< the button: all that it tells
  QWidget* progress_row_;
  QProgressBar* bar_;
  QLabel* stage_;
  QToolButton* cancel_;
  QLabel* outcome_;
};

}  // namespace glisson::ui
