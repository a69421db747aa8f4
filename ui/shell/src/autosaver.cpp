// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/autosaver.h"

#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>

#include "glisson/engine/commands/keep_copy.h"
#include "glisson/engine/commands/recover_case.h"

namespace glisson::ui {
namespace {

constexpr std::chrono::minutes kPeriod(2);

}  // namespace

Autosaver::Autosaver(EngineBridge& engine, QMainWindow& window, const std::filesystem::path& root)
    : QObject(&window), engine_(engine), window_(window), root_(root), folder_(root) {
  connect(&timer_, &QTimer::timeout, this, &Autosaver::keep);
  connect(&engine_, &EngineBridge::about_to_post, this, &Autosaver::keep_before_long_work);
  connect(&engine_, &EngineBridge::finished, this, &Autosaver::take);
  connect(&engine_, &EngineBridge::case_changed, this, &Autosaver::forget_what_is_saved,
          Qt::QueuedConnection);  // the window looks first whether anything is unsaved
  timer_.start(kPeriod);
}

void Autosaver::set_period(std::chrono::milliseconds period) { timer_.start(period); }

void Autosaver::keep() {
  const engine::Editions now = engine::editions(engine_.state());
  if (posting_ || copying_ || !window_.isWindowModified() || now == kept_) return;
  keeping_ = now;
  posting_ = true;
  copying_ = engine_.post(engine::KeepCopy{folder_.path(), saved_});
  posting_ = false;
}

void Autosaver::keep_before_long_work(const engine::CommandTraits& work) {
  // While the video is followed the clock alone decides: a person waits for what is begun then.
  if (engine_.snapshot()->tracking) return;
  const bool is_long =
      work.lane == engine::Lane::work && work.notice == engine::Notice::ordinary && !work.writes.empty();
  if (is_long || work.live == engine::LiveLane::tracking) keep();
}

void Autosaver::take(const engine::Outcome& outcome) {
  if (copying_ == outcome.id) {
    copying_.reset();
    // A copy that fails (a full disk) is tried again at the next turn; the work goes on.
    if (outcome.status == engine::Status::done) kept_ = keeping_;
    forget_what_is_saved();
    return;
  }
  if (recovering_ != outcome.id) return;
  recovering_.reset();
  // The old copy goes once there is a new one: see below. One that could not be opened stays where it is.
  if (outcome.status == engine::Status::done)
    keep();
  else
    recovered_ = {};
}

void Autosaver::forget_what_is_saved() {
  if (copying_) return;
  if (!recovered_.folder.empty() && !kept_.empty()) {
    engine::discard(recovered_);
    recovered_ = {};
  }
  if (window_.isWindowModified() || kept_.empty()) return;
  folder_.clear();
  kept_.clear();
}

void Autosaver::offer_recovery() {
  offered_ = engine::find_recoverable(root_);
  if (!offered_.empty()) ask(offered_.front());
}

void Autosaver::ask(const engine::Recoverable& copy) {
  const QString name =
      copy.of.empty() ? tr("a case that had never been saved") : QString::fromStdString(copy.of.string());
  auto* box = new QMessageBox(QMessageBox::Question, tr("Recovery"),
                              tr("Glisson ended before this was saved: %1, as it was at %2.")
                                  .arg(name, QString::fromStdString(copy.saved)),
                              QMessageBox::NoButton, &window_);
  box->setObjectName(QStringLiteral("recovery"));
  box->setInformativeText(
      tr("It can be opened as it was then. Nothing is saved in its place until you save it."));
  auto* recover = box->addButton(tr("Open it"), QMessageBox::AcceptRole);
  recover->setObjectName(QStringLiteral("recover"));
  auto* drop = box->addButton(tr("Throw it away"), QMessageBox::DestructiveRole);
  drop->setObjectName(QStringLiteral("discard"));
  auto* later = box->addButton(tr("Ask later"), QMessageBox::RejectRole);
  box->setDefaultButton(recover);
  box->setEscapeButton(later);
  box->setAttribute(Qt::WA_DeleteOnClose);
  connect(recover, &QPushButton::clicked, this, [this, copy] {
    recovered_ = copy;
    offered_.clear();  // the others are asked about at the next start
    recovering_ = engine_.post(engine::RecoverCase{copy});
  });
  connect(drop, &QPushButton::clicked, this, [copy] { engine::discard(copy); });
  connect(box, &QMessageBox::finished, this, [this] {
    if (!offered_.empty()) offered_.erase(offered_.begin());
    if (!offered_.empty()) ask(offered_.front());
  });
  box->open();  // does not stop the window
}

}  // namespace glisson::ui
