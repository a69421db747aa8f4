// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QWidget>
#include <map>

#include "glisson/ui/common/view_state.h"

class QSpinBox;
class QToolButton;

namespace glisson::ui {

/// The strip above the views: how the slices are shown. Each of its controls is an action with a key, too.
class ViewBar : public QWidget {
  Q_OBJECT
 public:
  explicit ViewBar(ViewState& state, QWidget* parent = nullptr);

  QAction* preset_action(WindowPreset preset) const { return presets_.at(preset); }
  /// Takes zoom and shift of the slices away.
  QAction* whole_action() const { return whole_; }
  /// Checked: one view fills the place of all.
  QAction* alone_action() const { return alone_; }
  /// All of them, for a menu: groups with lines between.
  const QList<QAction*>& all_actions() const { return all_; }
  /// Keys mean something only while the views are seen.
  void set_live(bool live);

 private:
  QAction* add_action(const char* name, const QString& text, const QKeySequence& key,
                      const QString& explanation = {});
  void add_line();
  QToolButton* add_button(QAction* action, const char* icon = nullptr);
  void build_windows();
  void build_slab();
  void build_measures();
  void build_layout();
  void show_state();

  ViewState& state_;
  std::map<WindowPreset, QAction*> presets_;
  QAction* no_hounsfield_ = nullptr;  ///< says why some do not apply
  std::map<MeasureTool, QAction*> measures_;
  QAction* undo_measure_ = nullptr;
  QAction* wipe_measures_ = nullptr;
  QAction* slab_ = nullptr;
  QSpinBox* thickness_ = nullptr;
  QAction* whole_ = nullptr;
  QAction* alone_ = nullptr;
  QToolButton* windows_ = nullptr;
  QList<QAction*> all_;
  bool live_ = false;
};

}  // namespace glisson::ui
