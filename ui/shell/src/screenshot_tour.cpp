// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/screenshot_tour.h"

#include <QBuffer>
#include <QPixmap>
#include <QSaveFile>
#include <QTimer>
#include <array>

#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/scene/picture_image.h"

namespace glisson::ui {
namespace {

constexpr std::array<const char*, 6> kNames = {"welcome", "segmentation", "model",
                                               "atlas",   "stereo",       "guidance"};
constexpr int kSettle = 700;        ///< milliseconds for a panel to draw itself
constexpr int kLivePictures = 6;    ///< tracked before the live view is taken
constexpr int kLongestWait = 8000;  ///< milliseconds for them
constexpr int kAsk = 20;            ///< milliseconds between questions

/// Bright colours rounded to `bits`: a camera's noise makes the files of a manual several times as large.
QImage rounded(QImage image, unsigned bits) {
  image.convertTo(QImage::Format_RGB32);
  const QRgb low = 0x00010101U * ((1U << bits) - 1U);
  for (int y = 0; y < image.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < image.width(); ++x)
      if ((row[x] & 0x00c0c0c0U) != 0) row[x] = (row[x] & ~low) | (low / 2U & low);
  }
  return image;
}

/// As many of the colours' bits as the file's size allows.
bool save_light(const QImage& image, const QString& path) {
  constexpr qsizetype kLargestFile = 380000;  // bytes
  QByteArray bytes;
  for (const unsigned bits : {2U, 3U, 4U}) {
    bytes.clear();
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!rounded(image, bits).save(&buffer, "PNG", 0)) return false;
    if (bytes.size() <= kLargestFile) break;
  }
  QSaveFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
}

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
  if (!live) return QTimer::singleShot(kSettle, this, &ScreenshotTour::shoot);
  const auto* guidance = window_.findChild<GuidancePanel*>();
  auto* question = new QTimer(this);
  connect(
      question, &QTimer::timeout, this,
      [this, question, guidance, wanted = guidance->pictures_shown() + kLivePictures, asked = 0]() mutable {
        if (guidance->pictures_shown() < wanted && ++asked * kAsk < kLongestWait) return;
        question->deleteLater();
        shoot();
      });
  question->start(kAsk);
}

void ScreenshotTour::shoot() {
  const QString file = QStringLiteral("%1/%2.png")
                           .arg(folder_, QString::fromLatin1(kNames[static_cast<std::size_t>(step_ + 1)]));
  all_saved_ = save_light(window_.grab().toImage(), file) && all_saved_;
  if (step_ == MainWindow::guidance) {
    const Picture& augmented = window_.findChild<GuidancePanel*>()->picture().picture();
    if (!augmented.empty())
      all_saved_ =
          save_light(scene::copy_to_image(augmented), folder_ + QStringLiteral("/overlay.png")) && all_saved_;
    emit finished(all_saved_);
    return;
  }
  ++step_;
  visit();
}

}  // namespace glisson::ui
