// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glisson/engine/commands/build_atlas.h"
#include "glisson/ui/atlas/atlas_choice.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/common/task_dialog.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;

namespace glisson::ui {

/// Builds an atlas of this person's cases: which cases, what it is called, where it is kept; and afterwards
/// how well each liver is foretold by the others.
class BuildAtlasDialog : public TaskDialog {
  Q_OBJECT
 public:
  /// @param choice its atlas is the base that the new one is built on
  BuildAtlasDialog(EngineBridge& engine, AtlasChoice& choice, QWidget* parent = nullptr);

  void add_cases(const QString& folder);
  void keep_in(const QString& folder);
  /// What the dialog asks the engine for, as it is filled in.
  engine::BuildAtlas command() const;
  TaskButton& task() { return *build_; }

 signals:
  /// The folder that it lies in.
  void built(const std::filesystem::path& folder);

 private:
  QLayout* make_cases();
  QLayout* make_place();
  void show_state();
  void show_outcome(const engine::Outcome& outcome);

  AtlasChoice& choice_;
  std::filesystem::path asked_out_;  ///< of what was asked last
  QListWidget* cases_ = nullptr;
  QLineEdit *name_ = nullptr, *folder_ = nullptr;
  QCheckBox *unapproved_ = nullptr, *keep_shape_ = nullptr, *summed_ = nullptr;
  TaskButton* build_ = nullptr;
  QLabel* notes_ = nullptr;
};

}  // namespace glisson::ui
