// SPDX-License-Identifier: GPL-3.0-or-later
#include "wheel_guard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QScrollBar>

#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

/// Null: none, or not on a panel.
QWidget* setting_on_panel(QObject* watched) {
  const bool is_setting =
      qobject_cast<QComboBox*>(watched) != nullptr || qobject_cast<QAbstractSpinBox*>(watched) != nullptr ||
      (qobject_cast<QAbstractSlider*>(watched) != nullptr && qobject_cast<QScrollBar*>(watched) == nullptr);
  if (!is_setting) return nullptr;
  auto* setting = static_cast<QWidget*>(watched);
  for (QWidget* above = setting->parentWidget(); above != nullptr; above = above->parentWidget())
    if (qobject_cast<Panel*>(above) != nullptr) return setting;
  return nullptr;
}

}  // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Polish && event->type() != QEvent::Wheel) return false;
  QWidget* setting = setting_on_panel(watched);
  if (setting == nullptr) return false;
  if (event->type() == QEvent::Polish) {
    // Otherwise the wheel itself would choose it.
    if (setting->focusPolicy() == Qt::WheelFocus) setting->setFocusPolicy(Qt::StrongFocus);
    return false;
  }
  if (setting->hasFocus()) return false;
  event->ignore();  // goes on to what is around it
  return true;
}

}  // namespace glisson::ui
