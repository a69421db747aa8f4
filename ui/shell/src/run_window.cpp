// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/run_window.h"

#include <QApplication>
#include <QFile>
#include <QIcon>
#include <QStyleFactory>

#include "glisson/core/claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/log_file.h"
#include "glisson/engine/outcome_log.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/render_view.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/shell/autosaver.h"
#include "glisson/ui/shell/language.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/shell/operations_ahead.h"
#include "glisson/ui/shell/screenshot_tour.h"

// The resources are in a static library: without a mention the linker leaves them out.
static void load_resources() { Q_INIT_RESOURCE(resources); }

namespace glisson::ui {

void prepare_application() { RenderView::prepare_surface_format(); }

void dress_application(QApplication& application) {
  load_resources();
  QApplication::setApplicationName(QStringLiteral("glisson"));
  QApplication::setApplicationDisplayName(QStringLiteral("Glisson"));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/glisson/icons/glisson.svg")));
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  set_up_language(application);
  QFile style(QStringLiteral(":/glisson/styles/dark.qss"));
  if (style.open(QIODevice::ReadOnly)) application.setStyleSheet(QString::fromUtf8(style.readAll()));
}

namespace {

/// Null: no copies can be kept here, which the log says.
Autosaver* make_autosaver(MainWindow& window) {
  try {
    const std::filesystem::path root = engine::recovery_root();
    return root.empty() ? nullptr : new Autosaver(window.engine(), window, root);
  } catch (const Error& failure) {
    log_to_file(log_folder()).write(LogLevel::warning, "no recovery: " + logged_error(failure.what()));
    return nullptr;
  }
}

}  // namespace

int run_window(int argc, char** argv, const std::filesystem::path& path) {
  prepare_application();
  QApplication application(argc, argv);
  dress_application(application);
  MainWindow window;
  window.show();
  const Log log = log_to_file(log_folder());
  QObject::connect(
      &window.engine(), &EngineBridge::finished, &application,
      [&log](const engine::Outcome& outcome) { engine::log_outcome(log, outcome, logged_error); });
  if (const auto* guidance = window.findChild<GuidancePanel*>())
    QObject::connect(
        &guidance->live(), &LiveViewModel::times_told, &application,
        [&log](const ScreenTimes& times) { log.write(LogLevel::info, "live view: " + line_of(times)); });
  sweep_leftovers(work_folder());
  Autosaver* autosaver = make_autosaver(window);
  new OperationsAhead(window.engine(), window);  // the window's
  if (!path.empty()) window.open(path);
  const QString screenshots = qEnvironmentVariable("GLISSON_SCREENSHOTS");
  if (autosaver != nullptr && screenshots.isEmpty()) autosaver->offer_recovery();
  ScreenshotTour tour(window, screenshots);
  if (!screenshots.isEmpty()) {
    QObject::connect(&tour, &ScreenshotTour::finished, &application,
                     [](bool saved) { QApplication::exit(saved ? 0 : 1); });
    tour.start();
  }
  return QApplication::exec();
}

}  // namespace glisson::ui
