// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <set>
#include <vector>

#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/view_state.h"
#include "glisson/ui/segmentation/branch_preview.h"
#include "glisson/ui/segmentation/edit_tools.h"
#include "glisson/ui/segmentation/level_outline.h"

class QTimer;

namespace glisson::ui {

/// The hand at work: the chosen tool and its settings, drags in the views as edits for the engine, previews,
/// undo and redo. No widgets; nothing is computed here.
class EditSession : public QObject {
  Q_OBJECT
 public:
  EditSession(EngineBridge& engine, ViewState& views, QObject* parent = nullptr);

  EditTool tool() const { return tool_; }
  /// Null: none. None is taken up while a new segmentation waits for a decision.
  void set_tool(EditTool tool);
  const EditSettings& settings() const { return settings_; }
  void set_settings(const EditSettings& settings);
  /// While the session does not have the views, tools do not hear them.
  void set_active(bool on);
  bool is_active() const { return active_; }

  /// Labels that have voxels, ascending.
  const std::vector<Label>& present() const { return present_; }
  /// Why the tool cannot be used now.
  EditObstacle obstacle() const;
  /// The same for people; empty: it can.
  QString why_not() const;

  /// Whether intensities are Hounsfield units: of a CT, and while there is no image.
  bool shows_hounsfield() const;
  /// Of the case; null: there is none.
  const std::shared_ptr<const editing::History>& history() const { return engine_.state()[part::history]; }
  /// Neither while a new segmentation waits for a decision: a step would let it go.
  bool can_undo() const;
  bool can_redo() const;
  void undo();
  void redo();

  /// Of the tool as it is set. @pre is_previewed()
  void preview();
  void apply();
  /// Whether the preview that is shown is of the tool as it is set.
  bool shows_preview() const;
  long voxels_to_change() const;
  /// Of a label, before and after what is previewed; voxels.
  struct VolumeChange {
    Label label = 0;
    long before = 0, after = 0;
  };
  /// Of each label that would change; the background is not among them.
  const std::vector<VolumeChange>& volume_changes() const { return volume_changes_; }
  double ml_of(long voxels) const;
  /// What a click at the pointer would move; null: nothing, or another tool is at hand.
  const std::shared_ptr<const BranchPreview::Shown>& branch() const { return branch_->shown(); }
  /// Clicks of a tool that takes several, so far.
  std::size_t clicked() const { return clicked_.size(); }
  /// A preview or an edit is being computed: its part that is done.
  std::optional<double> progress() const;
  /// Drops the line that is drawn or the clicks so far, else what is computed or previewed, else the tool.
  void escape();
  void cancel();

  void set_review(Label label, ReviewState state);
  /// Why the last edit could not be done; empty: it could.
  const std::string& problem() const { return problem_; }
  /// What it had to say: codes with values.
  const std::vector<std::string>& notes() const { return notes_; }

 signals:
  /// An edit is about to be made: a number that is still being typed is meant for it.
  void settings_wanted();
  void tool_changed();
  void settings_changed();
  /// Labels, history, preview, progress or problem.
  void changed();

 private:
  /// Null: there is none, or it is of a former image.
  std::shared_ptr<const engine::EditPreview> current_preview() const;
  std::optional<editing::Edit> whole() const;
  void show_hand();
  void show_pointer();
  void show_case();
  void show_preview();
  void hear(const SliceGesture& gesture);
  void drag_brush(const SliceGesture& gesture);
  void drag_lasso(const SliceGesture& gesture);
  void click(const SliceGesture& gesture);
  void add_click(const SliceGesture& gesture);
  void drop_clicks();
  /// What a click there is; empty: nothing. @pre there is an image
  std::optional<editing::Edit> edit_at(const PointerPlace& place, Qt::KeyboardModifiers keys) const;
  void cut_volume(const VolumeLasso& lasso);
  /// Sends what was drawn since the last time.
  void send_stroke();
  void finish_stroke();
  void post_edit(const editing::Edit& edit);
  /// Steps that the history will have done once the engine has caught up, over those that it has.
  int steps_ahead() const;
  void take(const engine::Outcome& outcome);
  void settings_have_changed();
  void drop_preview();
  void measure_preview();

  EngineBridge& engine_;
  ViewState& views_;
  EditTool tool_ = nullptr;
  EditSettings settings_;
  bool active_ = false;
  std::shared_ptr<const LabelMap> listed_;
  std::vector<Label> present_;

  struct Stroke {
    std::uint64_t gesture = 0;
    scene::SliceGeometry slice;  ///< that the path is drawn in
    bool invert = false;
    std::vector<Eigen::Vector3d> path;  ///< from the last point that was sent
    bool has_news = false;
    std::set<engine::CommandId> sent;  ///< that are not done yet
    bool ended = false;
  };
  std::optional<Stroke> stroke_;
  std::uint64_t gestures_ = 0;
  std::vector<Eigen::Vector2d> outline_;  ///< of a lasso in a slice, pixels

  std::vector<Eigen::Vector3d> clicked_;     ///< of a tool that takes several; CT frame
  std::shared_ptr<const Image> clicked_in_;  ///< the case's

  LevelOutline* traced_ = nullptr;
  BranchPreview* branch_ = nullptr;
  QTimer* soon_ = nullptr;  ///< a preview follows the settings when they rest
  std::optional<engine::CommandId> previewing_, applying_;
  bool is_replaced_ = false;  ///< other labels are on their way
  std::shared_ptr<const engine::EditPreview> measured_;
  std::vector<VolumeChange> volume_changes_;   ///< of measured_
  std::set<engine::CommandId> edits_;          ///< that are not done yet
  std::set<engine::CommandId> undos_, redos_;  ///< the same
  std::set<engine::CommandId> reviews_;        ///< the same
  std::string problem_;
  std::vector<std::string> notes_;
};

}  // namespace glisson::ui
