// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "glisson/ui/guidance/review_model.h"

namespace glisson::ui {

/// The frames that were followed, in a row: coloured by their level, with a mark where it changed, and the
/// one on the screen. Press or drag to go to another.
class TimelineTrack : public QWidget {
  Q_OBJECT
 public:
  explicit TimelineTrack(QWidget* parent = nullptr);

  void set_range(int first, int last);
  void set_position(int index);
  void set_marks(const std::vector<LevelMark>& marks);
  QSize sizeHint() const override { return {240, 26}; }
  QSize minimumSizeHint() const override { return {80, 26}; }
  /// Where a frame stands, widget coordinates.
  double place_of(int index) const;

 signals:
  void wanted(int index);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  void ask_for(double x);

  int first_ = 0, last_ = 0, position_ = 0;
  std::vector<LevelMark> marks_;
};

}  // namespace glisson::ui
