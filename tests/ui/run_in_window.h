// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include "glisson/ui/shell/run_window.h"

namespace glisson {

/// The main of a test that drives the window: dressed as the program dresses it, and in English, because the
/// tests read what the window says.
template <class Test>
int run_in_window(int argc, char** argv) {
  qputenv("LC_ALL", "C.UTF-8");
  qunsetenv("LANGUAGE");
  const QTemporaryDir settings;  // not the user's own
  qputenv("GLISSON_SETTINGS", settings.path().toUtf8());
  ui::prepare_application();
  QApplication application(argc, argv);
  ui::dress_application(application);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace glisson
