// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>

#include "glisson/ui/segmentation/edit_session.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace glisson::ui {

/// The tools of the hand: undo and redo, the tools with their shortcuts, the chosen one's settings, preview
/// and apply, and where anything may be changed.
class EditBox : public QWidget {
  Q_OBJECT
 public:
  /// @param page the tools' keys work while it is in sight.
  EditBox(EditSession& session, QWidget& page, QWidget* parent = nullptr,
          const EditTools& tools = edit_tools());

  /// Puts a widget below the tool's settings and what is said of its edit.
  void add_below_settings(QWidget* widget);
  QAction* undo_action() const { return undo_; }
  QAction* redo_action() const { return redo_; }

 private:
  void build_history();
  void build_tools(QWidget& page);
  void build_confirmation(QWidget& page);
  void build_region();
  /// The number that is being typed, if one is, counts as entered.
  void take_typed();
  void show_tool();
  /// What a click at the pointer would do.
  QString text_of(const BranchPreview::Shown& shown) const;
  /// What becomes of each label by what is previewed, a line each.
  QString volumes_text() const;
  void show_state();
  void show_region();

  EditSession& session_;
  const EditTools known_;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QToolButton* undo_button_ = nullptr;
  QToolButton* redo_button_ = nullptr;
  std::map<EditTool, QToolButton*> tools_;
  QLabel* tool_name_ = nullptr;
  QLabel* hint_ = nullptr;
  QWidget* confirmation_ = nullptr;
  QPushButton* preview_ = nullptr;
  QPushButton* apply_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* outcome_ = nullptr;
  QComboBox* area_ = nullptr;
  QCheckBox* by_intensity_ = nullptr;
  QWidget* intensities_ = nullptr;
  QDoubleSpinBox* low_ = nullptr;
  QDoubleSpinBox* high_ = nullptr;
};

}  // namespace glisson::ui
