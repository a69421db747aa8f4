// SPDX-License-Identifier: GPL-3.0-or-later
#include "running_work.h"

#include <QMessageBox>
#include <QPushButton>
#include <utility>

#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

using engine::Notice;

/// Work with a result that is worth a question.
bool is_work(const engine::CommandTraits& traits) { return traits.notice == Notice::ordinary; }

}  // namespace

RunningWork::Wish RunningWork::closing(std::function<void()> then) {
  return {tr("Close"),
          tr("Closing now stops it: what it would have made is lost, and the case stays as it is."),
          tr("Wait, then close"),
          tr("Stop it and close"),
          tr("Do not close"),
          tr("then the window closes"),
          [](const engine::CommandTraits& traits) {
            return is_work(traits) || traits.notice == Notice::files;  // a file is being written, too
          },
          std::move(then)};
}

RunningWork::Wish RunningWork::saving(std::function<void()> then) {
  return {tr("Save"),
          tr("Waiting saves the case with what it makes; a segmentation that would change what you corrected "
             "by hand waits for your decision then, and the labels are saved as they are. Stopping it saves "
             "the case as it is now."),
          tr("Wait, then save"),
          tr("Stop it and save"),
          tr("Do not save"),
          tr("then the case is saved"),
          is_work,
          std::move(then)};
}

RunningWork::Wish RunningWork::opening(const engine::CommandTraits& traits, std::function<void()> then) {
  return {tr("Open"),
          tr("Stopping it loses what it would have made."),
          tr("Wait, then open"),
          tr("Stop it and open"),
          tr("Do not open"),
          tr("then it is opened"),
          [writes = traits.writes](const engine::CommandTraits& running) {
            return is_work(running) && writes.meets(running.writes);
          },
          std::move(then)};
}

RunningWork::RunningWork(EngineBridge& engine, QWidget* window)
    : QObject(window), engine_(engine), window_(window) {
  connect(&engine_, &EngineBridge::finished, this, &RunningWork::take);
}

std::vector<Task> RunningWork::work_of(const Wish& wish) const {
  std::vector<Task> work;
  for (const Task& task : engine_.tasks())
    if (wish.concerns(task.traits)) work.push_back(task);
  return work;
}

void RunningWork::before(Wish wish) {
  take_back();
  const std::vector<Task> work = work_of(wish);
  if (work.empty()) return wish.then();
  wish_ = std::move(wish);
  ask(work);
}

void RunningWork::ask(const std::vector<Task>& work) {
  QStringList names;
  for (const Task& task : work) names << command_text(task.traits.code);
  names.removeDuplicates();
  auto* box = new QMessageBox(QMessageBox::Question, wish_->title,
                              tr("Still at work: %1.").arg(names.join(QStringLiteral(", "))),
                              QMessageBox::NoButton, window_);
  box->setObjectName(QStringLiteral("running_work"));
  box->setInformativeText(wish_->told);
  box->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, const char* name, QMessageBox::ButtonRole role) {
    QPushButton* button = box->addButton(text, role);
    button->setObjectName(QLatin1String(name));
    return button;
  };
  const QPushButton* wait = add(wish_->wait, "wait_for_work", QMessageBox::AcceptRole);
  const QPushButton* stop = add(wish_->stop, "stop_work", QMessageBox::DestructiveRole);
  QPushButton* leave = add(wish_->leave, "leave_work", QMessageBox::RejectRole);
  box->setDefaultButton(leave);
  box->setEscapeButton(leave);
  question_ = box;
  connect(box, &QMessageBox::finished, this, [this, box, wait, stop] {
    if (question_ != box) return;
    question_.clear();
    if (box->clickedButton() == wait)
      wait_for_work();
    else if (box->clickedButton() == stop)
      stop_work();
    else
      take_back();
  });
  box->open();  // does not stop the window
}

void RunningWork::wait_for_work() {
  for (const Task& task : work_of(*wish_)) awaited_.insert(task.id);
  if (awaited_.empty()) return proceed();
  emit waits(wish_->afterwards);
}

void RunningWork::stop_work() {
  stops_ = true;
  wait_for_work();
  for (const engine::CommandId id : std::set(awaited_)) engine_.cancel(id);
}

void RunningWork::take(const engine::Outcome& outcome) {
  if (!wish_) return;
  if (question_) {
    if (work_of(*wish_).empty()) tell_end();
    return;
  }
  if (awaited_.erase(outcome.id) == 0) return;
  // Work that could not be stopped in time has changed the case: the person looks at it first.
  const bool as_said = (outcome.status == engine::Status::done) != stops_;
  if (!as_said) return take_back();
  if (awaited_.empty()) proceed();
}

void RunningWork::tell_end() {
  question_->setText(tr("The work has ended meanwhile."));
  question_->setInformativeText({});
  if (auto* stop = question_->findChild<QPushButton*>(QStringLiteral("stop_work"))) stop->setEnabled(false);
}

void RunningWork::take_back() {
  const bool waited = !awaited_.empty();
  wish_.reset();
  awaited_.clear();
  stops_ = false;
  if (question_) question_->deleteLater();
  question_.clear();
  if (waited) emit waits({});
}

void RunningWork::proceed() {
  const std::function<void()> then = std::move(wish_->then);
  wish_.reset();
  stops_ = false;
  emit waits({});
  // When everybody has heard how the work ended.
  QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
}

}  // namespace glisson::ui
