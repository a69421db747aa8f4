// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/guidance/live_view.h"
#include "glisson/ui/guidance/organ_view.h"

class QPushButton;
class QSplitter;

namespace glisson::ui {

/// What guidance shows in the middle of the window: the augmented picture, the organ in three dimensions, or
/// both: side by side, or one above the other where the picture is larger so. That it was both is remembered,
/// and how much of the room each had.
class GuidanceView : public QWidget {
  Q_OBJECT
 public:
  /// Takes both.
  GuidanceView(LiveView* live, OrganView* organ, QWidget* parent = nullptr);
  const LiveView& live() const { return *live_; }
  /// Unless it is there already.
  void show_picture();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum Page { picture, organ, both };
  void turn_to(int page);
  /// As somebody has shared the room out last.
  void share_out();

  LiveView* live_;
  OrganView* organ_;
  QSplitter* splitter_;
  QPushButton* picture_;
};

}  // namespace glisson::ui
