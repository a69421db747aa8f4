// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/run_window.h"

#include <QApplication>
#include <QFile>
#include <QIcon>
#include <QStyleFactory>

#include "glisson/ui/common/render_view.h"
#include "glisson/ui/shell/language.h"
#include "glisson/ui/shell/main_window.h"
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

int run_window(int argc, char** argv, const std::filesystem::path& path) {
  prepare_application();
  QApplication application(argc, argv);
  dress_application(application);
  MainWindow window;
  window.show();
  if (!path.empty()) window.open(path);
  const QString screenshots = qEnvironmentVariable("GLISSON_SCREENSHOTS");
  ScreenshotTour tour(window, screenshots);
  if (!screenshots.isEmpty()) {
    QObject::connect(&tour, &ScreenshotTour::finished, &application,
                     [](bool saved) { QApplication::exit(saved ? 0 : 1); });
    tour.start();
  }
  return QApplication::exec();
}

}  // namespace glisson::ui
