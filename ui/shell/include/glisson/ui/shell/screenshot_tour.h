// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>

#include "glisson/ui/shell/main_window.h"

namespace glisson::ui {

/// Walks through the panels of a window that has a case open and saves a picture of each: segmentation.png,
/// editing.png (a brush at work) and preview.png (a threshold before it is applied), model.png, atlas.png,
/// stereo.png, guidance.png (with the live view running where there is a video), and its augmented picture
/// alone as overlay.png; of a window without a case welcome.png first. For the manual: run the program with
/// GLISSON_SCREENSHOTS set to a folder.
class ScreenshotTour : public QObject {
  Q_OBJECT
 public:
  ScreenshotTour(MainWindow& window, const QString& folder, QObject* parent = nullptr);
  /// Waits for whatever the engine is doing, then walks.
  void start();

 signals:
  void finished(bool all_saved);

 private:
  void visit();
  void shoot();
  void show_brush();
  void show_threshold();
  /// Goes on once something holds, or after a while all the same.
  void shoot_when(const std::function<bool()>& ready);

  MainWindow& window_;
  QString folder_;
  std::size_t stop_ = 0;
  bool all_saved_ = true;
  bool started_ = false;
};

}  // namespace glisson::ui
