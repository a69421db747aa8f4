// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/task_button.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {
constexpr int kGap = 5;  ///< pixels between the lines
}  // namespace

TaskButton::TaskButton(EngineBridge& engine, const QString& text,
                       std::function<std::optional<engine::Command>()> make, QWidget* parent)
    : QWidget(parent), engine_(engine), make_(std::move(make)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGap);
  button_ = new QPushButton(text, this);
  button_->setProperty("role", "run");
  layout->addWidget(button_);

  below_ = new QWidget(this);
  auto* lines = new QVBoxLayout(below_);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(kGap);
  progress_row_ = new QWidget(below_);
  auto* row = new QHBoxLayout(progress_row_);
  row->setContentsMargins(0, 0, 0, 0);
  bar_ = new QProgressBar(progress_row_);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  cancel_ = new QToolButton(progress_row_);
  cancel_->setText(tr("Cancel"));
  row->addWidget(bar_, 1);
  row->addWidget(cancel_);
  lines->addWidget(progress_row_);
  stage_ = make_explanation({}, below_);
  lines->addWidget(stage_);
  outcome_ = new QLabel(below_);
  outcome_->setWordWrap(true);
  outcome_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  lines->addWidget(outcome_);
  lines->addStretch(1);
  outcome_->hide();
  layout->addWidget(below_);
  layout->addStretch(1);  // what room a panel has to spare does not push the button down

  connect(button_, &QPushButton::clicked, this, &TaskButton::start);
  connect(cancel_, &QToolButton::clicked, this, [this] {
    if (running_) engine_.cancel(*running_);
    if (cancel_->hasFocus()) setFocus();
    cancel_->setEnabled(false);
    stage_->setText(tr("Cancelling…"));
  });
  connect(&engine_, &EngineBridge::tasks_changed, this, &TaskButton::show_tasks);
  connect(&engine_, &EngineBridge::finished, this, &TaskButton::show_outcome);
  connect(&engine_, &EngineBridge::case_changed, this,
          [this, number = engine_.snapshot()->case_number]() mutable {
            const std::uint64_t former = std::exchange(number, engine_.snapshot()->case_number);
            if (former == number) return;
            outcome_->hide();  // it was said of another case
            show_state();
          });
  show_state();
}

void TaskButton::set_obstacle(const QString& obstacle) {
  obstacle_ = obstacle;
  show_state();
}

void TaskButton::reserve_lines() {
  stage_->ensurePolished();
  const QString said = stage_->text();
  stage_->setText(QStringLiteral("X"));
  below_->setMinimumHeight(progress_row_->sizeHint().height() + kGap + stage_->sizeHint().height());
  stage_->setText(said);
  is_reserved_ = true;
  show_state();
}

void TaskButton::watch(engine::Command command) {
  if (!watched_) connect(&engine_, &EngineBridge::case_changed, this, &TaskButton::ask);
  watched_ = std::move(command);
  ask();
}

void TaskButton::ask() {
  asked_ = obstacle_text(engine::obstacle(*engine_.snapshot(), *watched_));
  show_state();
}

void TaskButton::trigger() {
  if (!running_ && obstacle().isEmpty()) start();
}

void TaskButton::start() {
  const std::optional<engine::Command> command = make_();
  if (!command) return;
  outcome_->hide();
  cancel_->setEnabled(true);
  bar_->setValue(0);
  running_ = engine_.post(*command);
  show_tasks();
  show_state();
}

void TaskButton::show_tasks() {
  if (!running_) return;
  for (const Task& task : engine_.tasks())
    if (task.id == *running_) {
      bar_->setValue(static_cast<int>(1000 * task.fraction));
      if (cancel_->isEnabled()) stage_->setText(task.stage.empty() ? tr("Waiting…") : stage_text(task.stage));
    }
}

void TaskButton::show_outcome(const engine::Outcome& outcome) {
  if (!running_ || outcome.id != *running_) return;
  running_.reset();
  switch (outcome.status) {
    case engine::Status::done:
      outcome_->setText(tr("Done in %1 s").arg(outcome.seconds, 0, 'f', 1));
      set_style_property(outcome_, "role", "good");
      break;
    case engine::Status::cancelled:
      outcome_->setText(tr("Cancelled; nothing was changed"));
      set_style_property(outcome_, "role", "muted");
      break;
    case engine::Status::failed:
      outcome_->setText(error_text(outcome.error));
      set_style_property(outcome_, "role", "error");
      break;
  }
  outcome_->show();
  show_state();
  emit done(outcome);
}

void TaskButton::show_state() {
  const QString first = obstacle();
  const bool is_possible = !running_ && first.isEmpty();
  // What cannot be pressed hands the keyboard on, and the next in the row is Cancel: one more press of the
  // key would take back what the first has begun. It waits here until the button is there again.
  if ((!is_possible && button_->hasFocus()) || (!running_ && cancel_->hasFocus())) setFocus();
  progress_row_->setVisible(running_.has_value());
  stage_->setVisible(running_.has_value() || !first.isEmpty());
  button_->setEnabled(is_possible);
  if (is_possible && hasFocus()) button_->setFocus();
  if (!running_) stage_->setText(first);
  if (!first.isEmpty()) outcome_->hide();
  // Nothing to say: the layout's gap above it goes with it.
  below_->setVisible(is_reserved_ || running_ || !first.isEmpty() || !outcome_->isHidden());
}

}  // namespace glisson::ui
