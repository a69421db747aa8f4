// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/edit_session.h"

#include <QDateTime>
#include <QGuiApplication>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/preview_edit.h"
#include "glisson/engine/commands/redo_labels.h"
#include "glisson/engine/commands/set_review.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/patient/label_difference.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/segmentation/edit_texts.h"
#include "glisson/ui/segmentation/slice_circle.h"

namespace glisson::ui {
namespace {

constexpr int kRest = 250;  ///< milliseconds

using Outline = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

Points points_of(const std::vector<Eigen::Vector3d>& path) {
  Points points(static_cast<Eigen::Index>(path.size()), 3);
  for (std::size_t i = 0; i < path.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = path[i].transpose();
  return points;
}

/// A ring about a click, in its slice.
std::shared_ptr<const SliceLine> ring_about(const SliceGesture& gesture, Label label) {
  constexpr double kRadius = 2e-3;
  return line_of({gesture.p.xyz, kRadius, gesture.slice.right.normalized(), gesture.slice.down.normalized()},
                 gesture, label);
}

/// Whether a line encloses anything: three corners, some pixels wide and high.
bool encloses(const Outline& outline, double pixel) {
  if (outline.rows() < 3) return false;
  const Eigen::Array2d size = (outline.colwise().maxCoeff() - outline.colwise().minCoeff()).transpose();
  return size.minCoeff() > pixel;
}

}  // namespace

EditSession::EditSession(EngineBridge& engine, ViewState& views, QObject* parent)
    : QObject(parent),
      engine_(engine),
      views_(views),
      // Gestures are told apart for as long as a case's history lives.
      gestures_(static_cast<std::uint64_t>(QDateTime::currentMSecsSinceEpoch())) {
  traced_ = new LevelOutline(views, this);
  branch_ = new BranchPreview(
      views,
      [this](const PointerPlace& place) { return edit_at(place, QGuiApplication::keyboardModifiers()); },
      this);
  connect(branch_, &BranchPreview::changed, this, [this] {
    show_preview();
    emit changed();
  });
  soon_ = new QTimer(this);
  soon_->setSingleShot(true);
  soon_->setInterval(kRest);
  connect(soon_, &QTimer::timeout, this, &EditSession::preview);
  connect(&views_, &ViewState::gestured, this, &EditSession::hear);
  connect(&views_, &ViewState::volume_lassoed, this, &EditSession::cut_volume);
  connect(&views_, &ViewState::brush_turned, this, [this](double notches) {
    if (hand_of(tool_, settings_) != Hand::brush) return;  // it is somebody else's brush
    EditSettings next = settings_;
    next.brush_radius = brush_after(next.brush_radius, notches);
    set_settings(next);
  });
  connect(&engine_, &EngineBridge::case_changed, this, &EditSession::show_case);
  connect(&engine_, &EngineBridge::finished, this, &EditSession::take);
  connect(&engine_, &EngineBridge::tasks_changed, this, [this] {
    const bool was_replaced = std::exchange(is_replaced_, is_being_replaced(engine_, part::labels));
    if (previewing_ || applying_ || is_replaced_ != was_replaced) emit changed();
  });
  show_case();
}

void EditSession::set_tool(EditTool tool) {
  if (tool == tool_) return;
  // What it would change lets the offer go: first comes the decision. Its key is heard meanwhile.
  if (tool != nullptr && engine_.state()[part::offer]) return;
  finish_stroke();
  drop_clicks();
  drop_preview();
  problem_.clear();
  notes_.clear();
  tool_ = tool;
  branch_->set_tool(tool);  // before anybody asks what is shown
  emit tool_changed();      // whoever had the mouse lets go of it
  show_hand();
  settings_have_changed();
}

void EditSession::set_settings(const EditSettings& settings) {
  if (settings == settings_) return;
  finish_stroke();
  settings_ = settings;
  if (tool_ != nullptr) show_hand();  // else the views are somebody else's
  emit settings_changed();
  settings_have_changed();
}

void EditSession::show_pointer() {
  const auto shows = [&](WindowTool::AtPointer what) {
    return active_ && tool_ != nullptr && tool_->at_pointer == what && obstacle() == EditObstacle::none;
  };
  const bool traces = shows(WindowTool::AtPointer::outline);
  traced_->set_label(traces ? std::optional(settings_.label) : std::nullopt);
  const bool moves = shows(WindowTool::AtPointer::branch) || shows(WindowTool::AtPointer::way);
  branch_->set_case(moves ? engine_.state()[part::image] : nullptr,
                    moves ? engine_.state()[part::labels] : nullptr);
}

void EditSession::settings_have_changed() {
  problem_.clear();
  show_pointer();
  // Growing takes its time: it waits to be asked.
  if (active_ && is_previewed(tool_, settings_) && !tool_->is_slow && obstacle() == EditObstacle::none) {
    soon_->start();
  } else {
    soon_->stop();
    if (!shows_preview()) drop_preview();
  }
  show_preview();
  emit changed();
}

void EditSession::set_active(bool on) {
  if (on == active_) return;
  if (!on) set_tool(nullptr);
  active_ = on;
  show_pointer();
  emit changed();
}

void EditSession::show_hand() {
  views_.set_hand(hand_of(tool_, settings_));
  const bool erases = tool_ != nullptr && tool_->erases;
  views_.set_brush(
      {settings_.brush_radius, settings_.ball, erases ? structure::kBackground : settings_.label});
}

EditObstacle EditSession::obstacle() const {
  if (engine::obstacle(*engine_.snapshot(), engine::EditLabels{})) return EditObstacle::case_first;
  if (is_replaced_) return EditObstacle::replaced;
  if (engine_.state()[part::offer]) return EditObstacle::offered;
  return obstacle_of(tool_, settings_, present_);
}

QString EditSession::why_not() const {
  const auto first = engine::obstacle(*engine_.snapshot(), engine::EditLabels{});
  return first ? obstacle_text(first) : obstacle_text(obstacle());
}

void EditSession::show_case() {
  if (engine_.state()[part::image] != clicked_in_) {
    clicked_in_ = engine_.state()[part::image];
    problem_.clear();  // of what was done to the former one
    notes_.clear();
    drop_clicks();
    stroke_.reset();  // what is left of it would be drawn into another patient
    outline_.clear();
  }
  const auto& labels = engine_.state()[part::labels];
  if (labels != listed_) {
    listed_ = labels;
    present_.clear();
    if (const auto& statistics = engine_.state()[part::statistics])
      for (const auto& [label, figures] : statistics->figures())
        if (label != structure::kBackground && figures.voxels > 0) present_.push_back(label);
  }
  measure_preview();
  show_pointer();
  show_preview();
  emit changed();
}

void EditSession::measure_preview() {
  const auto preview = engine_.state()[part::preview];
  if (preview == measured_) return;
  measured_ = preview;
  volume_changes_.clear();
  if (!preview) return;
  const LabelVolume& after = preview->result.labels.voxels;
  const LabelVolume none(after.grid());
  const LabelDifference difference =
      label_difference(preview->base ? preview->base->voxels : none, after, none);
  const auto& statistics = engine_.state()[part::statistics];
  for (const auto& [label, shift] : difference.labels) {
    VolumeChange change{label, 0, 0};
    if (statistics && statistics->figures().count(label) > 0)
      change.before = statistics->figures().at(label).voxels;
    change.after = change.before + shift.gained - shift.lost;
    volume_changes_.push_back(change);
  }
}

int EditSession::steps_ahead() const {
  return static_cast<int>(edits_.size()) + static_cast<int>(redos_.size()) - static_cast<int>(undos_.size());
}

bool EditSession::can_undo() const {
  if (is_replaced_ || engine_.state()[part::offer]) return false;  // it would be lost
  const auto& history = engine_.state()[part::history];
  return (history ? static_cast<int>(history->done()) : 0) + steps_ahead() > 0;
}

bool EditSession::can_redo() const {
  if (is_replaced_ || engine_.state()[part::offer]) return false;
  const auto& history = engine_.state()[part::history];
  return history && edits_.empty() &&
         static_cast<int>(history->done()) + steps_ahead() < static_cast<int>(history->steps().size());
}

void EditSession::undo() {
  finish_stroke();  // what was drawn is undone, not left behind
  problem_.clear();
  if (!can_undo()) return;
  undos_.insert(engine_.post(engine::UndoLabels{}));
}

void EditSession::redo() {
  finish_stroke();
  problem_.clear();
  if (!can_redo()) return;
  redos_.insert(engine_.post(engine::RedoLabels{}));
}

void EditSession::hear(const SliceGesture& gesture) {
  if (!active_ || !engine_.state()[part::image]) return;
  switch (hand_of(tool_, settings_)) {
    case Hand::brush:
      drag_brush(gesture);
      break;
    case Hand::lasso:
      drag_lasso(gesture);
      break;
    case Hand::point:
      click(gesture);
      break;
    case Hand::crosshair:
    case Hand::span:
    case Hand::box:  // no tool's
      break;
  }
}

void EditSession::drag_brush(const SliceGesture& gesture) {
  if (gesture.phase == SliceGesture::Phase::begin) {
    finish_stroke();
    if (obstacle() != EditObstacle::none) return;
    problem_.clear();
    stroke_ = Stroke();
    stroke_->gesture = ++gestures_;
    stroke_->slice = gesture.slice;
    stroke_->invert = gesture.keys.testFlag(Qt::ControlModifier);
  }
  if (!stroke_) return;
  if (gesture.slice.origin != stroke_->slice.origin) {
    // The wheel turned to another slice in the middle of the drag: nothing was drawn in those between.
    send_stroke();
    stroke_->path.clear();
    stroke_->slice = gesture.slice;
  }
  if (stroke_->path.empty() || stroke_->path.back() != gesture.p.xyz) {
    stroke_->path.push_back(gesture.p.xyz);
    stroke_->has_news = true;
  }
  stroke_->ended = gesture.phase == SliceGesture::Phase::end;
  // While the engine is at the last piece the next one grows: a slow machine draws in larger pieces, but
  // never falls behind the hand.
  if (stroke_->sent.empty()) send_stroke();
}

void EditSession::send_stroke() {
  if (stroke_->has_news) {
    for (const editing::Edit& edit : brush_edits(tool_, settings_, engine_.state()[part::image]->grid,
                                                 stroke_->slice, points_of(stroke_->path), stroke_->invert)) {
      const engine::CommandId id = engine_.post(engine::EditLabels{edit, stroke_->gesture});
      stroke_->sent.insert(id);
      edits_.insert(id);
    }
    stroke_->path = {stroke_->path.back()};
    stroke_->has_news = false;
  }
  if (stroke_->ended && stroke_->sent.empty()) stroke_.reset();
}

void EditSession::finish_stroke() {
  if (stroke_ && stroke_->has_news) send_stroke();
  stroke_.reset();
  outline_.clear();
}

void EditSession::drag_lasso(const SliceGesture& gesture) {
  if (gesture.phase == SliceGesture::Phase::begin) outline_.clear();
  outline_.push_back(gesture.slice.pixel_of(gesture.p));
  if (gesture.phase != SliceGesture::Phase::end) return;
  Outline outline(static_cast<Eigen::Index>(outline_.size()), 2);
  for (std::size_t i = 0; i < outline_.size(); ++i)
    outline.row(static_cast<Eigen::Index>(i)) = outline_[i].transpose();
  outline_.clear();
  if (!encloses(outline, 1.0) || obstacle() != EditObstacle::none) return;
  post_edit(slice_cut(settings_, engine_.state()[part::image]->grid, gesture.slice, outline,
                      gesture.keys.testFlag(Qt::ControlModifier)));
}

void EditSession::cut_volume(const VolumeLasso& lasso) {
  if (!active_ || hand_of(tool_, settings_) != Hand::lasso || !engine_.state()[part::image]) return;
  emit settings_wanted();  // unlike a slice the 3D view does not take the keyboard from a number
  if (!encloses(lasso.outline, 1e-3) || obstacle() != EditObstacle::none) return;
  post_edit(volume_cut(settings_, lasso, lasso.keys.testFlag(Qt::ControlModifier)));
}

std::optional<editing::Edit> EditSession::edit_at(const PointerPlace& place,
                                                  Qt::KeyboardModifiers keys) const {
  if (tool_->chain) {
    if (clicked_.empty()) return std::nullopt;
    std::vector<Eigen::Vector3d> path = clicked_;
    path.push_back(place.p.xyz);
    return editing::Edit{tool_->chain(settings_, points_of(path)), settings_.region};
  }
  const Image& image = *engine_.state()[part::image];
  const LabelVolume* labels =
      engine_.state()[part::labels] ? &engine_.state()[part::labels]->voxels : nullptr;
  const Label clicked = scene::probe(image, labels, place.p).label;
  return click_edit(tool_, settings_, image.grid, place.plane, place.p, clicked,
                    keys.testFlag(Qt::ControlModifier));
}

void EditSession::click(const SliceGesture& gesture) {
  if (gesture.phase != SliceGesture::Phase::begin || obstacle() != EditObstacle::none) return;
  if (tool_->chain) return add_click(gesture);
  if (const auto edit = edit_at({gesture.slice.plane, gesture.p}, gesture.keys)) post_edit(*edit);
}

void EditSession::add_click(const SliceGesture& gesture) {
  const bool last = !clicked_.empty() && !gesture.keys.testFlag(Qt::ControlModifier);
  const auto edit = last ? edit_at({gesture.slice.plane, gesture.p}, gesture.keys) : std::nullopt;
  problem_.clear();
  notes_.clear();
  if (edit) {
    drop_clicks();
    return post_edit(*edit);
  }
  clicked_.push_back(gesture.p.xyz);
  views_.set_line(ring_about(gesture, settings_.label));
  show_pointer();
  emit changed();
}

void EditSession::drop_clicks() {
  if (clicked_.empty()) return;
  clicked_.clear();
  views_.set_line(nullptr);
  show_pointer();
}

void EditSession::post_edit(const editing::Edit& edit) {
  problem_.clear();
  notes_.clear();
  applying_ = engine_.post(engine::EditLabels{edit, 0});
  edits_.insert(*applying_);
  emit changed();
}

std::optional<editing::Edit> EditSession::whole() const {
  if (!is_previewed(tool_, settings_) || obstacle() != EditObstacle::none) return std::nullopt;
  return whole_edit(tool_, settings_, engine_.state()[part::image]->grid, present_);
}

void EditSession::preview() {
  soon_->stop();
  const auto edit = whole();
  if (!edit || shows_preview()) return;
  if (previewing_) engine_.cancel(*previewing_);
  problem_.clear();
  previewing_ = engine_.post(engine::PreviewEdit{edit});
  emit changed();
}

void EditSession::apply() {
  emit settings_wanted();
  soon_->stop();
  const auto edit = whole();
  if (!edit || applying_) return;
  // A preview of this very edit that is on its way is not thrown away: the engine takes its result.
  post_edit(*edit);
}

void EditSession::drop_preview() {
  soon_->stop();
  if (previewing_) engine_.cancel(*previewing_);
  previewing_.reset();
  if (engine_.state()[part::preview]) engine_.post(engine::PreviewEdit{});
  views_.set_preview(nullptr);
}

std::shared_ptr<const engine::EditPreview> EditSession::current_preview() const {
  const engine::Snapshot& now = *engine_.snapshot();
  return now.stage(part::preview) == engine::StageState::current ? now.state[part::preview] : nullptr;
}

bool EditSession::shows_preview() const {
  const auto preview = current_preview();
  const auto edit = preview ? whole() : std::nullopt;
  return edit && preview->edit == *edit;
}

long EditSession::voxels_to_change() const {
  return shows_preview() ? engine_.state()[part::preview]->result.voxels_changed : 0;
}

double EditSession::ml_of(long voxels) const {
  return engine_.state()[part::image]
             ? 1e-3 * engine_.state()[part::image]->grid.voxel_volume_mm3() * static_cast<double>(voxels)
             : 0.0;
}

void EditSession::show_preview() {
  if (const auto& moved = branch_->shown(); moved && moved->result.voxels_changed > 0)
    return views_.set_preview(std::shared_ptr<const LabelMap>(moved, &moved->result.labels));
  // The former one stays in sight while the settings move, until the next is there.
  const auto preview = current_preview();
  const auto edit = preview ? whole() : std::nullopt;
  const bool same_tool = edit && &edit->tool.kind() == &preview->edit.tool.kind();
  views_.set_preview(same_tool ? std::shared_ptr<const LabelMap>(preview, &preview->result.labels) : nullptr);
}

std::optional<double> EditSession::progress() const {
  for (const Task& task : engine_.tasks())
    if (task.id == applying_ || task.id == previewing_) return task.fraction;
  return std::nullopt;
}

void EditSession::cancel() {
  if (applying_) engine_.cancel(*applying_);
  drop_preview();
  emit changed();
}

void EditSession::escape() {
  if (stroke_ || !outline_.empty()) {
    finish_stroke();
    views_.drop_gesture();
    return;
  }
  if (!clicked_.empty()) {
    drop_clicks();
    emit changed();
    return;
  }
  if (applying_ || previewing_ || soon_->isActive() || shows_preview()) return cancel();
  set_tool(nullptr);
}

void EditSession::set_review(Label label, ReviewState state) {
  reviews_.insert(engine_.post(engine::SetReview{label, state, engine_.state()[part::labels]}));
}

void EditSession::take(const engine::Outcome& outcome) {
  const bool edit = edits_.erase(outcome.id) > 0, preview = outcome.id == previewing_;
  const bool review = reviews_.erase(outcome.id) > 0;
  const bool in_history = undos_.erase(outcome.id) + redos_.erase(outcome.id) > 0;
  if (outcome.id == applying_) applying_.reset();
  if (preview) previewing_.reset();
  if ((edit || preview || review) && outcome.status == engine::Status::failed) problem_ = outcome.error;
  if ((edit || preview) && outcome.status == engine::Status::done) notes_ = outcome.notes;
  if (stroke_ && stroke_->sent.erase(outcome.id) > 0) {
    if (outcome.status == engine::Status::failed)
      stroke_.reset();  // every further piece would fail alike
    else if (stroke_->sent.empty())
      send_stroke();
  }
  if (edit || preview || review || in_history) emit changed();
}

bool EditSession::shows_hounsfield() const {
  const auto& image = engine_.state()[part::image];
  return !image || image->modality == Modality::ct;
}

}  // namespace glisson::ui
