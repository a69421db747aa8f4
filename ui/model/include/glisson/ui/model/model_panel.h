// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/engine/commands/build_model.h"
#include "glisson/ui/common/linked_views.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/model/load_trial_box.h"
#include "glisson/ui/model/quality_sheet.h"
#include "glisson/ui/model/tree_editor.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;
class QVBoxLayout;

namespace glisson::ui {

/// Labels to the biomechanical model; its quality, and what of it is seen.
class ModelPanel : public Panel {
  Q_OBJECT
 public:
  ModelPanel(EngineBridge& engine, LinkedViews& views, QWidget* parent = nullptr);
  void deactivate() override;

 private:
  void build_options();
  /// A part of the panel that may be hidden as a whole; what belongs into it is added to its layout.
  QWidget* make_part(const QString& heading, const QString& explanation);
  void build_trees();
  void build_tissue();
  void build_trial();
  void build_look();
  void show_case();
  void show_structures();
  void import_surfaces(const QString& path, LengthUnit unit = LengthUnit::millimetre);
  /// Asks first in which unit they are.
  void import_in_a_unit(const QString& path);
  engine::BuildModel command() const;

  LinkedViews& views_;
  QComboBox* size_by_ = nullptr;
  QSpinBox* vertices_ = nullptr;
  QDoubleSpinBox* edge_ = nullptr;
  QCheckBox *vessels_ = nullptr, *fine_lesions_ = nullptr, *fine_vessels_ = nullptr;
  QSpinBox* beams_ = nullptr;
  QLabel* review_ = nullptr;  ///< which labels nobody has approved
  TaskButton* run_ = nullptr;
  QualitySheet* quality_ = nullptr;
  QWidget* trees_section_ = nullptr;
  TreeEditor* trees_ = nullptr;
  QWidget* tissue_section_ = nullptr;
  QWidget* trial_section_ = nullptr;
  LoadTrialBox* trial_ = nullptr;
  QWidget* look_ = nullptr;
  QVBoxLayout* structures_ = nullptr;
  std::shared_ptr<const model::BuiltModel> shown_;
};

}  // namespace glisson::ui
