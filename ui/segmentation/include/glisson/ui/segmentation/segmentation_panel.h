// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <vector>

#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/common/view_state.h"
#include "glisson/ui/segmentation/seed_book.h"

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QSlider;

namespace glisson::ui {

/// CT to labels: the operator clicks seeds in the slices, the engine grows the structures.
class SegmentationPanel : public Panel {
  Q_OBJECT
 public:
  SegmentationPanel(EngineBridge& engine, ViewState& views, QWidget* parent = nullptr);

  void activate() override;
  void deactivate() override;
  /// The seeds as they are on the screen.
  const segmentation::Seeds& seeds() const { return seeds_; }
  /// Clicks in the slices place seeds of this structure; none: they move the crosshair.
  void choose_structure(std::optional<Label> structure);

 private:
  void build_structures();
  void build_seed_list();
  void show_case();
  void show_seeds();
  void show_markers();
  void show_volumes();
  void place(const Point<CtFrame>& p);
  void store();
  void remove_selected();
  QString obstacle() const;

  ViewState& views_;
  segmentation::Seeds seeds_;
  std::shared_ptr<const segmentation::Seeds> taken_;
  std::shared_ptr<const LabelMap> measured_;  ///< whose volumes are shown
  std::set<engine::CommandId> storing_;
  bool active_ = false;
  std::optional<Label> structure_;
  std::vector<SeedEntry> entries_;
  std::map<Label, QPushButton*> buttons_;
  QGridLayout* grid_ = nullptr;
  QListWidget* list_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* clear_ = nullptr;
  QPushButton* save_ = nullptr;
  QDoubleSpinBox* spacing_ = nullptr;
  TaskButton* run_ = nullptr;
  FiguresTable* figures_ = nullptr;
  QLabel* notes_ = nullptr;
};

}  // namespace glisson::ui
