// SPDX-License-Identifier: GPL-3.0-or-later
#include "winding_up.h"

#include <QMessageBox>

namespace glisson::ui {

bool wind_up(const std::vector<Panel*>& panels, QWidget* window, const std::function<void()>& then,
             const std::function<void(const QString& problem)>& failed) {
  for (Panel* panel : panels) {
    const QString wait = panel->wind_up();
    if (wait.isEmpty()) continue;
    auto* box =
        new QMessageBox(QMessageBox::Information, window->windowTitle(), wait, QMessageBox::Cancel, window);
    box->setObjectName(QStringLiteral("winding_up"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(panel, &Panel::wound_up, box, [box, then, failed](const QString& problem) {
      box->disconnect();
      box->accept();
      problem.isEmpty() ? then() : failed(problem);
    });
    box->open();  // does not stop the window
    return true;
  }
  return false;
}

}  // namespace glisson::ui
