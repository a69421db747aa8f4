// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include "glisson/ui/atlas/atlas_choice.h"
#include "glisson/ui/common/engine_bridge.h"

class QLabel;
class QPushButton;

namespace glisson::ui {

class BuildAtlasDialog;

/// Which atlas proposes, and the menu that chooses another one or builds it.
class AtlasBox : public QWidget {
  Q_OBJECT
 public:
  AtlasBox(EngineBridge& engine, AtlasChoice& choice, QWidget* parent = nullptr);

  /// As when the person has named the folder; what is wrong with it is shown.
  void choose(const std::filesystem::path& folder);
  /// Null: it is not open.
  BuildAtlasDialog* dialog() const;

 private:
  void ask_for_folder();
  void open_dialog();
  void show_state();

  EngineBridge& engine_;
  AtlasChoice& choice_;
  QPointer<BuildAtlasDialog> dialog_;
  QString refused_;  ///< why the folder that was named last was not taken
  QPushButton* button_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* problem_ = nullptr;
  QLabel* other_ = nullptr;
};

}  // namespace glisson::ui
