// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/try_drawing.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <QString>
#include <QStringList>

#include "glisson/core/error.h"
#include "glisson/ui/scene/offscreen_renderer.h"

namespace glisson::scene {
namespace {

/// What a driver says of itself, out of VTK's report.
std::map<std::string, std::string> driver_in(const std::string& report) {
  std::map<std::string, std::string> driver;
  for (const QString& line : QString::fromStdString(report).split('\n')) {
    for (const char* name : {"vendor", "renderer", "version"}) {
      const QString start = QStringLiteral("OpenGL %1 string:").arg(QLatin1String(name));
      if (line.trimmed().startsWith(start))
        driver[name] = line.trimmed().mid(start.size()).trimmed().toStdString();
    }
  }
  return driver;
}

}  // namespace

std::map<std::string, std::string> try_drawing() {
  vtkNew<vtkRenderer> renderer;
  std::string report;
  vtkNew<vtkCallbackCommand> asks;
  asks->SetClientData(&report);
  asks->SetCallback([](vtkObject* caller, unsigned long, void* told, void*) {
    auto* window = vtkRenderer::SafeDownCast(caller)->GetRenderWindow();
    if (window != nullptr) *static_cast<std::string*>(told) = window->ReportCapabilities();
  });
  renderer->AddObserver(vtkCommand::EndEvent, asks);
  OffscreenRenderer drawing(64, 64);
  if (drawing.render(*renderer).empty())
    throw Error("drawing: nothing was drawn. Check the graphics driver.");
  return driver_in(report);
}

}  // namespace glisson::scene
