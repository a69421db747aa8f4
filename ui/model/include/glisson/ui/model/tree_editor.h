// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "glisson/model/tree_edits.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/linked_views.h"

class QAbstractButton;
class QButtonGroup;
class QLabel;
class QPushButton;
class QShortcut;

namespace glisson::ui {

/// Entrances are moved, branches pruned and trees joined by clicks on the centrelines in the 3D view. Every
/// click is one edit that can be undone. What a click would prune, or hang on another tree, is shown while
/// the pointer is over it.
class TreeEditor : public QWidget {
  Q_OBJECT
 public:
  TreeEditor(EngineBridge& engine, LinkedViews& views, QWidget* parent = nullptr);

  bool is_on() const { return tool_.has_value(); }
  /// Puts the tool away; the 3D view shows the vessels as before.
  void leave();
  QAbstractButton* tool_button(model::TreeEdit::Kind kind) const;
  QPushButton* undo_button() const { return undo_; }
  QPushButton* redo_button() const { return redo_; }

 signals:
  /// A tool was taken up.
  void began();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void choose(std::optional<model::TreeEdit::Kind> tool);
  void show_case();
  void show_message(const QString& sentence, bool is_problem = false);
  void take(const engine::Outcome& outcome);
  /// The tree's node under a place in the view, CT frame; empty: none is near.
  std::optional<Eigen::Vector3d> node_at(const QPointF& at) const;
  /// The place on a centreline under a place in the view, CT frame; empty: none is near.
  std::optional<Eigen::Vector3d> centreline_at(const QPointF& at) const;
  void click(const Eigen::Vector3d& place);
  /// Shows and says what a click there would do; empty: nothing. @pre the tool prunes or joins
  void hover(const std::optional<Eigen::Vector3d>& place);
  /// What a click there would prune.
  void show_cut(const Eigen::Vector3d& place);
  /// What a join there would do: which tree stays, or which one is hung on it.
  void show_join(const Eigen::Vector3d& place);
  /// In 3D; an empty tree: nothing.
  void mark(VesselTree part);
  static QString described(const VesselTree& tree);
  /// @param undone what can be redone if the work is done; else that stays as it was.
  void post(std::vector<model::TreeEdit> edits, std::vector<model::TreeEdit> undone);
  QString instruction() const;

  EngineBridge& engine_;
  LinkedViews& views_;
  QButtonGroup* tools_;
  QPushButton *undo_, *redo_;
  QLabel* message_;
  QShortcut* escape_;
  std::optional<model::TreeEdit::Kind> tool_;
  std::optional<Eigen::Vector3d> first_;        ///< of a join
  std::vector<model::TreeEdit> undone_;         ///< the last of them is redone first
  std::vector<model::TreeEdit> undone_before_;  ///< before what is posted, on the trees that are shown
  std::optional<engine::CommandId> posted_;
  std::optional<std::vector<model::TreeEdit>> expected_;  ///< edits of the model that the command will make
  std::shared_ptr<const model::BuiltModel> shown_;
};

}  // namespace glisson::ui
