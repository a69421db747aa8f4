// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/screenshot_tour.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QMouseEvent>
#include <QPixmap>
#include <QPushButton>
#include <QSaveFile>
#include <QTimer>
#include <array>

#include "glisson/editing/tools/threshold.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/video.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/scene/picture_image.h"
#include "glisson/ui/segmentation/segmentation_panel.h"

namespace glisson::ui {
namespace {

struct Stop {
  const char* name;
  int step;  ///< of the window; -1: none is open
};
constexpr std::array<Stop, 9> kStops = {{{"welcome", -1},
                                         {"segmentation", MainWindow::segmentation},
                                         {"editing", MainWindow::segmentation},
                                         {"preview", MainWindow::segmentation},
                                         {"model", MainWindow::model},
                                         {"atlas", MainWindow::atlas},
                                         {"stereo", MainWindow::stereo},
                                         {"organ", MainWindow::guidance},
                                         {"guidance", MainWindow::guidance}}};
constexpr int kSettle = 700;        ///< milliseconds for a panel to draw itself
constexpr int kLivePictures = 6;    ///< tracked before the live view is taken
constexpr int kLongestWait = 8000;  ///< milliseconds for what is waited for
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
    stop_ = window_.engine().state()[part::image] || window_.engine().state()[part::model] ? 1 : 0;
    QTimer::singleShot(kSettle, this, &ScreenshotTour::visit);
  };
  connect(&window_.engine(), &EngineBridge::tasks_changed, this, begin_when_idle);
  connect(&window_.drawables(), &DrawableSource::changed, this, begin_when_idle);
  begin_when_idle();
}

void ScreenshotTour::show_brush() {
  EditSession& session = window_.findChild<SegmentationPanel*>()->session();
  EditSettings settings = session.settings();
  settings.label = structure::kPortalVein;
  settings.brush_radius = 7e-3;
  settings.ball = true;
  session.set_settings(settings);
  session.set_tool(edit_tool("paint"));
  SliceView& axial = window_.views().slice(scene::Plane::axial);
  const QPointF middle(0.4 * axial.width(), 0.42 * axial.height());
  QMouseEvent move(QEvent::MouseMove, middle, axial.mapToGlobal(middle), Qt::NoButton, Qt::NoButton,
                   Qt::NoModifier);
  QCoreApplication::sendEvent(&axial, &move);
}

void ScreenshotTour::show_threshold() {
  EditSession& session = window_.findChild<SegmentationPanel*>()->session();
  EditSettings settings = session.settings();
  settings.label = structure::kHepaticVeins;
  auto& threshold = settings.of<editing::Threshold>();
  threshold.low = 140.0;
  threshold.high = 220.0;
  settings.region.area = editing::EditableRegion::Area::inside_liver;
  session.set_settings(settings);
  session.set_tool(edit_tool("threshold"));
}

void ScreenshotTour::shoot_when(const std::function<bool()>& ready) {
  auto* question = new QTimer(this);
  connect(question, &QTimer::timeout, this, [this, question, ready, asked = 0]() mutable {
    if (!ready() && ++asked * kAsk < kLongestWait) return;
    question->deleteLater();
    QTimer::singleShot(kSettle, this, &ScreenshotTour::shoot);
  });
  question->start(kAsk);
}

void ScreenshotTour::visit() {
  const Stop& stop = kStops[stop_];
  const std::string name = stop.name;
  if (stop.step >= 0 && window_.step() != stop.step) window_.show_step(stop.step);
  const auto& surfaces = window_.views().label_surfaces();
  if (name == "segmentation") return shoot_when([&surfaces] { return !surfaces.is_making(); });
  if (name == "editing") show_brush();
  if (name == "preview") {
    show_threshold();
    return shoot_when([this] { return window_.findChild<SegmentationPanel*>()->session().shows_preview(); });
  }
  if (name == "organ" || name == "guidance")
    window_.findChild<QPushButton*>(name == "organ" ? "show_organ" : "show_picture")->click();
  const engine::CaseState& now = window_.engine().state();
  const bool live = name == "guidance" && now[part::registration] && now[part::video];
  if (!live) {
    QTimer::singleShot(kSettle, this, &ScreenshotTour::shoot);
    return;
  }
  if (auto* button = window_.findChild<TaskButton*>(QStringLiteral("start_tracking"))) button->trigger();
  const auto* guidance = window_.findChild<GuidancePanel*>();
  const auto wanted = guidance->pictures_shown() + kLivePictures;
  shoot_when([guidance, wanted] { return guidance->pictures_shown() >= wanted; });
}

void ScreenshotTour::shoot() {
  const QString file = QStringLiteral("%1/%2.png").arg(folder_, QString::fromLatin1(kStops[stop_].name));
  all_saved_ = save_light(window_.grab().toImage(), file) && all_saved_;
  if (stop_ + 1 == kStops.size()) {
    const Picture& augmented = window_.findChild<GuidancePanel*>()->picture().picture();
    if (!augmented.empty())
      all_saved_ =
          save_light(scene::copy_to_image(augmented), folder_ + QStringLiteral("/overlay.png")) && all_saved_;
    emit finished(all_saved_);
    return;
  }
  ++stop_;
  visit();
}

}  // namespace glisson::ui
