// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/commands/calibrate_rig.h"
#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/common/task_dialog.h"
#include "glisson/ui/stereo/calibration_results.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace glisson::ui {

/// Calibrates the laparoscope from a folder of pairs of pictures of a board, and says how far to trust it.
class CalibrationDialog : public TaskDialog {
  Q_OBJECT
 public:
  explicit CalibrationDialog(EngineBridge& engine, QWidget* parent = nullptr);

  /// What the dialog asks the engine for, as it is filled in.
  engine::CalibrateRig command() const;
  TaskButton& task() { return *run_; }
  /// Calibrates again, with the views that are ticked.
  TaskButton& again() { return *again_; }

 private:
  QWidget* make_fields();
  QLayout* make_form(EngineBridge& engine);
  void choose_folder();
  /// The request has changed: what was found before does not belong to it.
  void change_request();
  void show_state();
  void show_outcome(const engine::Outcome& outcome);

  QWidget* fields_;  ///< what is asked for; not to be changed while it is looked for
  QLineEdit* folder_;
  QComboBox* kind_;
  QSpinBox* columns_;
  QSpinBox* rows_;
  QDoubleSpinBox* square_;
  QDoubleSpinBox* marker_;
  TaskButton* run_;
  TaskButton* again_;
  CalibrationResults* results_;
  FiguresTable* figures_;
  QLabel* notes_;
};

}  // namespace glisson::ui
