// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/engine_bridge.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace glisson::ui {

/// In the status bar: the command that runs, how far it is, and a way to cancel it; otherwise how the last
/// one ended.
class TaskStatus : public QWidget {
  Q_OBJECT
 public:
  explicit TaskStatus(EngineBridge& engine, QWidget* parent = nullptr);
  QString text() const;
  /// What is done when the work that runs has ended; empty: nothing.
  void set_afterwards(const QString& afterwards);

 private:
  void show_tasks();
  void show_outcome(const engine::Outcome& outcome);
  void show_done(const engine::Outcome& outcome);

  EngineBridge& engine_;
  engine::CommandId shown_ = 0;
  QString afterwards_;
  QLabel* text_;
  QProgressBar* bar_;
  QToolButton* cancel_;
};

}  // namespace glisson::ui
