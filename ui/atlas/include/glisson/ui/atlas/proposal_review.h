// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <set>
#include <vector>

#include "glisson/atlas/transfer.h"
#include "glisson/ui/atlas/area_painter.h"
#include "glisson/ui/atlas/atlas_choice.h"
#include "glisson/ui/atlas/move_proposal.h"
#include "glisson/ui/common/linked_views.h"
#include "glisson/ui/scene/proposal_actors.h"

class QLabel;
class QListWidget;
class QPushButton;
class QShortcut;

namespace glisson::ui {

class SurfaceDrag;
class TaskButton;

/// Lets the atlas propose the landmarks, and a person review them one by one: where they lie and how sure
/// that is, in three dimensions and in the slices; accept, move, not visible, undo, by mouse or keyboard.
class ProposalReview : public QWidget {
  Q_OBJECT
 public:
  /// @param choice the atlas that proposes
  ProposalReview(EngineBridge& engine, LinkedViews& views, ViewState& state, AtlasChoice& choice,
                 QWidget* parent = nullptr);

  /// The panel comes to the front, or leaves it: only then anything is drawn.
  void set_active(bool active);
  /// While the views show something else.
  void set_marks_hidden(bool hidden);
  /// What a drag over the liver in three dimensions does.
  enum class Tool { none, move, paint };
  Tool tool() const { return tool_; }
  void put_tool_away() { set_tool(Tool::none); }
  /// Of what is drawn in three dimensions.
  int actor_count() const { return actors_.actor_count(); }
  /// Whether the brush's border is drawn on the liver.
  bool shows_ring() const { return ring_.actor_count() > 0; }

 signals:
  /// The mouse works on a proposal from now on: other tools are put away.
  void tool_taken();
  void tool_changed();

 private:
  struct Former {
    atlas::Proposal proposal;
    Points landmark;             ///< of its structure, CT frame, metres
    Eigen::VectorXd deviations;  ///< of the landmark, metres
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
  /// They lie on a liver that is not drawn any more.
  bool is_of_former_model() const;
  void draw();
  /// @param moved where it lies now, CT frame.
  void decide(atlas::Decision decision, const Points& moved = {});
  void go_on();
  void undo();
  /// Places are in the CT frame, here and below.
  void set_tool(Tool wanted);
  /// A single act, as a click in a slice is.
  void move_to(const Eigen::Vector3d& p);
  void begin_drag(const Eigen::Vector3d& p, Qt::KeyboardModifiers keys);
  void drag(const Eigen::Vector3d& p, Qt::KeyboardModifiers keys);
  void end_drag();
  void end_painting();
  /// A drag in a slice with the brush.
  void paint_in_slice(const SliceGesture& gesture);
  void show_ring(const Eigen::Vector3d& p);
  void hide_ring();
  void set_brush(double radius);
  /// Shows the body again that hid what is painted.
  void uncover();
  /// What the case's model has changed to since is laid aside.
  void take_model();
  /// As the hand would leave it.
  atlas::Proposal as_dragged(const atlas::Proposal& one) const;

  EngineBridge& engine_;
  LinkedViews& views_;
  ViewState& state_;
  AtlasChoice& choice_;
  scene::ProposalActors actors_, ring_;
  std::shared_ptr<const atlas::Transfer> shown_;
  std::vector<Former> former_;
  std::set<engine::CommandId> posted_;
  bool active_ = false, marks_hidden_ = false;
  Tool tool_ = Tool::none;
  SurfaceDrag* drag_ = nullptr;
  std::shared_ptr<const model::BuiltModel> model_;  ///< that mover and painter are of
  std::unique_ptr<ProposalMover> mover_;
  std::unique_ptr<AreaPainter> painter_;
  bool dragging_ = false;
  Eigen::Index taken_ = 0;
  Points dragged_{0, 3};                        ///< where a proposal would be moved to; none: nowhere
  std::optional<atlas::Structure> dragged_of_;  ///< which one
  double brush_ = 8e-3;                         ///< metres
  std::optional<Label> hidden_;
  TaskButton* propose_ = nullptr;
  QWidget* review_ = nullptr;  ///< what there is once something is proposed
  QLabel* doubts_ = nullptr;
  QListWidget* list_ = nullptr;
  QLabel* reason_ = nullptr;
  QPushButton *accept_ = nullptr, *move_ = nullptr, *not_visible_ = nullptr, *undo_ = nullptr;
  QPushButton *paint_ = nullptr, *thinner_ = nullptr, *thicker_ = nullptr;
  QShortcut* here_ = nullptr;  ///< moves it to the crosshair
  std::vector<QShortcut*> keys_;
};

}  // namespace glisson::ui
