// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "glisson/engine/commands/calibrate_rig.h"
#include "glisson/ui/common/picture_view.h"

class QTreeWidget;
class QTreeWidgetItem;

namespace glisson::ui {

/// Where the boards lay in both pictures, with one of them brought out.
class CoverageView : public PictureView {
  Q_OBJECT
 public:
  explicit CoverageView(QWidget* parent = nullptr);
  void set_sheet(std::shared_ptr<const engine::CalibrationSheet> sheet);
  /// @param view index among the sheet's views; negative: none.
  void bring_out(int view);
  int brought_out() const { return view_; }

 protected:
  void paint_over(QPainter& painter) override;

 private:
  std::shared_ptr<const engine::CalibrationSheet> sheet_;
  int view_ = -1;
};

/// How far to trust a calibration: what its boards covered, and the error of each view, which can be
/// unticked. Views that are proposed for removal come unticked.
class CalibrationResults : public QWidget {
  Q_OBJECT
 public:
  enum Column { name, left, right, rows, distance, tilt };

  explicit CalibrationResults(QWidget* parent = nullptr);

  /// Null: nothing is shown.
  void set_sheet(std::shared_ptr<const engine::CalibrationSheet> sheet);
  const std::shared_ptr<const engine::CalibrationSheet>& sheet() const { return sheet_; }
  /// Names of the views that are not ticked.
  std::vector<std::string> unticked() const;
  /// Whether the ticks are other than what was calibrated with.
  bool differs() const;

 signals:
  void ticks_changed();

 private:
  QTreeWidgetItem* make_row(std::size_t view) const;

  std::shared_ptr<const engine::CalibrationSheet> sheet_;
  CoverageView* coverage_;
  QTreeWidget* views_;
};

}  // namespace glisson::ui
