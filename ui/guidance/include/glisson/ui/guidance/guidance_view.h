// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/guidance/live_view.h"
#include "glisson/ui/guidance/organ_view.h"

class QPushButton;
class QStackedWidget;

namespace glisson::ui {

/// What guidance shows in the middle of the window: the augmented picture, or the registered organ in three
/// dimensions.
class GuidanceView : public QWidget {
  Q_OBJECT
 public:
  /// Takes both.
  GuidanceView(LiveView* live, OrganView* organ, QWidget* parent = nullptr);
  const LiveView& live() const { return *live_; }
  void show_picture();

 private:
  LiveView* live_;
  QStackedWidget* stack_;
  QPushButton* picture_;
};

}  // namespace glisson::ui
