// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/screenshot_tour.h"

#include <QPixmap>
#include <QTimer>
#include <array>

#include "glisson/ui/common/task_button.h"

namespace glisson::ui {
namespace {

constexpr std::array<const char*, 6> kNames = {"welcome", "segmentation", "model",
                                               "atlas",   "stereo",       "guidance"};
constexpr int kSettle = 700;     ///< milliseconds for a panel to draw itself
constexpr int kLiveView = 2500;  ///< milliseconds of tracking before its picture

}  // namespace

ScreenshotTour::ScreenshotTour(MainWindow& window, const QString& folder, QObject* parent)
    : QObject(parent), window_(window), folder_(folder) {}

void ScreenshotTour::start() {
  const auto begin_when_idle = [this] {
    if (started_ || !window_.engine().tasks().empty() || window_.drawables().is_preparing()) return;
    started_ = true;
    step_ = window_.engine().state().image || window_.engine().state().model ? 0 : -1;
    QTimer::singleShot(kSettle, this, &ScreenshotTour::visit);
  };
  connect(&window_.engine(), &EngineBridge::tasks_changed, this, begin_when_idle);
  connect(&window_.drawables(), &DrawableSource::changed, this, begin_when_idle);
  begin_when_idle();
}

void ScreenshotTour::visit() {
  if (step_ >= 0) window_.show_step(step_);
  const engine::CaseState& now = window_.engine().state();
  const bool live = step_ == MainWindow::guidance && now.registration && now.video;
  if (live) {
    if (auto* button = window_.findChild<TaskButton*>(QStringLiteral("start_tracking"))) button->trigger();
  }
  QTimer::singleShot(live ? kLiveView : kSettle, this, &ScreenshotTour::shoot);
}

void ScreenshotTour::shoot() {
  const QString file = QStringLiteral("%1/%2.png")
                           .arg(folder_, QString::fromLatin1(kNames[static_cast<std::size_t>(step_ + 1)]));
  all_saved_ = window_.grab().save(file) && all_saved_;
  if (step_ == MainWindow::guidance) {
    emit finished(all_saved_);
    return;
  }
  ++step_;
  visit();
}

}  // namespace glisson::ui
