// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <set>
#include <vector>

#include "glisson/atlas/transfer.h"
#include "glisson/ui/common/linked_views.h"
#include "glisson/ui/scene/proposal_actors.h"

class QLabel;
class QListWidget;
class QPushButton;
class QShortcut;

namespace glisson::ui {

class TaskButton;

/// Lets the atlas propose the landmarks, and a person review them one by one: where they lie and how sure
/// that is, in three dimensions and in the slices; accept, move, not visible, undo, by mouse or keyboard.
class ProposalReview : public QWidget {
  Q_OBJECT
 public:
  ProposalReview(EngineBridge& engine, LinkedViews& views, ViewState& state, QWidget* parent = nullptr);

  /// The panel comes to the front, or leaves it: only then anything is drawn.
  void set_active(bool active);
  /// While the views show something else.
  void set_marks_hidden(bool hidden);
  bool is_moving() const { return moving_; }
  void stop_moving() { set_moving(false); }
  /// Of what is drawn in three dimensions.
  int actor_count() const { return actors_.actor_count(); }

 signals:
  /// A click moves a proposal from now on: other tools are put away.
  void moving_began();

 private:
  struct Former {
    atlas::Proposal proposal;
    Points landmark;  ///< of its structure
  };
  QPushButton* add_button(const QString& text, const QString& explanation, const QKeySequence& key);
  void make_list();
  const atlas::Proposal* chosen() const;
  void show_case();
  void show_list();
  /// The crosshair goes there, too.
  void choose(int row);
  void show_chosen();
  /// Whether a step of the review would be taken now.
  bool is_open() const;
  void draw();
  void decide(atlas::Decision decision, const Points& moved = {});
  void go_on();
  void undo();
  void set_moving(bool on);
  void move_to(const Eigen::Vector3d& p);

  EngineBridge& engine_;
  LinkedViews& views_;
  ViewState& state_;
  scene::ProposalActors actors_;
  std::shared_ptr<const atlas::Transfer> shown_;
  std::vector<Former> former_;
  std::set<engine::CommandId> posted_;
  bool active_ = false, moving_ = false, marks_hidden_ = false;
  TaskButton* propose_ = nullptr;
  QWidget* review_ = nullptr;  ///< what there is once something is proposed
  QLabel* doubts_ = nullptr;
  QListWidget* list_ = nullptr;
  QLabel* reason_ = nullptr;
  QPushButton *accept_ = nullptr, *move_ = nullptr, *not_visible_ = nullptr, *undo_ = nullptr;
  std::vector<QShortcut*> keys_;
};

}  // namespace glisson::ui
