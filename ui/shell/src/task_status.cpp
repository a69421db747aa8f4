// SPDX-License-Identifier: GPL-3.0-or-later
#include "task_status.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "glisson/engine/parts/labels.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

/// Small edits pass too quickly to be announced.
bool is_worth_telling(const engine::CommandTraits& command) {
  return command.notice != engine::Notice::quiet;
}

}  // namespace

TaskStatus::TaskStatus(EngineBridge& engine, QWidget* parent) : QWidget(parent), engine_(engine) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 8, 2);
  text_ = new QLabel(this);
  text_->setTextFormat(Qt::PlainText);
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long errors do not widen the window
  bar_ = new QProgressBar(this);
  bar_->setObjectName(QStringLiteral("task_progress"));
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(220);
  cancel_ = new QToolButton(this);
  cancel_->setText(tr("Cancel"));
  row->addWidget(text_, 1);
  row->addWidget(bar_);
  row->addWidget(cancel_);
  QSizePolicy keeps_its_place = cancel_->sizePolicy();
  keeps_its_place.setRetainSizeWhenHidden(true);  // the views above do not jump when work begins
  cancel_->setSizePolicy(keeps_its_place);
  bar_->hide();
  cancel_->hide();
  connect(&engine_, &EngineBridge::tasks_changed, this, &TaskStatus::show_tasks);
  connect(&engine_, &EngineBridge::finished, this, &TaskStatus::show_outcome);
  connect(cancel_, &QToolButton::clicked, this, [this] { engine_.cancel(shown_); });
}

QString TaskStatus::text() const { return text_->text(); }

void TaskStatus::set_afterwards(const QString& afterwards) {
  afterwards_ = afterwards;
  show_tasks();
}

void TaskStatus::show_tasks() {
  const Task* running = nullptr;
  for (const Task& task : engine_.tasks())
    if (is_worth_telling(task.traits) && (running == nullptr || running->stage.empty())) running = &task;
  bar_->setVisible(running != nullptr);
  cancel_->setVisible(running != nullptr);
  if (running == nullptr) return;
  shown_ = running->id;
  bar_->setValue(static_cast<int>(1000 * running->fraction));
  // Work that nobody has asked for speaks in its bar: what was said of other work, an error maybe, stays.
  const bool is_unasked = running->traits.notice == engine::Notice::unasked;
  bar_->setFormat(is_unasked ? command_text(running->traits.code) : QString());
  bar_->setTextVisible(is_unasked);
  if (is_unasked) return;
  set_style_property(text_, "role", "");
  text_->setToolTip({});
  const QString text = running->stage.empty()
                           ? command_text(running->traits.code)
                           : tr("%1: %2").arg(command_text(running->traits.code), stage_text(running->stage));
  text_->setText(afterwards_.isEmpty() ? text : tr("%1 – %2").arg(text, afterwards_));
}

void TaskStatus::show_done(const engine::Outcome& outcome) {
  const QString name = command_text(outcome.command), seconds = QString::number(outcome.seconds, 'f', 1);
  // Where a panel is longer than the window, what it notes may be out of sight, and this line never is. Of
  // files notes are told in a box.
  const bool is_ordinary = outcome.traits.notice == engine::Notice::ordinary;
  // A case that is opened brings along what its segmentation tells.
  const auto kept = outcome.traits.replaces_case() ? engine::told_of_labels(engine_.state()).size() : 0;
  const auto notes = is_ordinary ? outcome.notes.size() : 0;
  set_style_property(text_, "role", notes + kept > 0 ? "warning" : "");
  text_->setText(
      notes > 0 ? tr("%1: done in %2 s – notes to read, on the right: %3").arg(name, seconds).arg(notes)
      : kept > 0 ? tr("%1: done in %2 s – notes to read, under Segmentation: %3").arg(name, seconds).arg(kept)
                 : tr("%1: done in %2 s").arg(name, seconds));
}

void TaskStatus::show_outcome(const engine::Outcome& outcome) {
  if (outcome.traits.notice == engine::Notice::unasked) return;
  switch (outcome.status) {
    case engine::Status::done:
      if (!is_worth_telling(outcome.traits)) return;
      show_done(outcome);
      break;
    case engine::Status::cancelled:
      set_style_property(text_, "role", "");
      text_->setText(tr("%1: cancelled").arg(command_text(outcome.command)));
      break;
    case engine::Status::failed:
      set_style_property(text_, "role", "error");
      text_->setText(error_text(outcome.error));
      break;
  }
  text_->setToolTip(outcome.status == engine::Status::failed ? text_->text() : QString());
}

}  // namespace glisson::ui
