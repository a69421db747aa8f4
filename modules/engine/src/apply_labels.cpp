// SPDX-License-Identifier: GPL-3.0-or-later
// The labels: import, segmentation, edits by hand, undo and redo, review.
#include <set>

#include "apply_parts.h"
#include "glisson/core/error.h"

namespace glisson::engine {
namespace {

/// Labels of which a voxel came or went.
std::set<Label> labels_touched(const LabelChanges& changes) {
  std::set<Label> touched;
  std::pair<Label, Label> last{0, 0};
  for (const LabelChange& change : changes)
    for (std::size_t i = 0; i < LabelVolume::Brick().size(); ++i) {
      const std::pair<Label, Label> now{change.before ? (*change.before)[i] : Label{0},
                                        change.after ? (*change.after)[i] : Label{0}};
      if (now.first == now.second || now == last) continue;
      touched.insert({now.first, now.second});
      last = now;
    }
  touched.erase(structure::kBackground);
  return touched;
}

/// Whoever touches a label has begun with it; what was approved must be looked at again.
Review review_after(const Review& review, const std::set<Label>& touched) {
  Review next = review;
  for (const Label label : touched) {
    ReviewState& state = next[label];
    if (state == ReviewState::not_started) state = ReviewState::in_progress;
    if (state == ReviewState::approved) state = ReviewState::to_review;
  }
  return next;
}

Review review_of(const CaseState& state) { return state.review ? *state.review : Review{}; }

LabelMap labels_of(const CaseState& state) {
  if (state.labels) return *state.labels;
  LabelMap none;
  none.voxels = LabelVolume(state.image->grid);
  return none;
}

editing::History history_of(const CaseState& state) {
  return state.history ? *state.history : editing::History();
}

void put_review(CaseState& state, const Review& review) {
  if (review != review_of(state)) state.review = std::make_shared<const Review>(review);
}

/// Puts labels in place, with their figures; the preview was of others.
void put_labels(CaseState& state, LabelMap labels, editing::History history) {
  const bool measurable = state.image && state.image->grid.same_as(labels.voxels.grid());
  state.statistics = std::make_shared<const segmentation::LabelStatistics>(
      labels, measurable ? state.image.get() : nullptr, state.statistics.get());
  state.labels = std::make_shared<const LabelMap>(std::move(labels));
  state.history = std::make_shared<const editing::History>(std::move(history));
  state.preview = nullptr;
}

/// Puts the labels in place that a step made of `before`. @return those of which a voxel came or went.
std::set<Label> step_to(CaseState& state, const LabelMap& before, LabelMap labels,
                        const editing::StepName& name, std::uint64_t gesture = 0) {
  LabelChanges changes = labels.voxels.changes_since(before.voxels);
  std::set<Label> touched = labels_touched(changes);
  editing::History history =
      history_of(state).with({name, std::move(changes), before.infos, labels.infos, gesture});
  put_labels(state, std::move(labels), std::move(history));
  return touched;
}

/// Labels that a whole step made anew. @return as step_to().
std::set<Label> replace_labels(CaseState& state, LabelMap labels, const editing::StepName& name) {
  const VolumeGrid& grid = labels.voxels.grid();
  if (state.labels && state.labels->voxels.grid().same_as(grid))
    return step_to(state, LabelMap(*state.labels), std::move(labels), name);  // a copy: its bricks are shared
  // Steps on another grid lead nowhere, nor is there a way back to no labels at all.
  std::set<Label> touched = labels_touched(labels.voxels.changes_since(LabelVolume(grid)));
  put_labels(state, std::move(labels), editing::History());
  return touched;
}

void report_labels(const CaseState& state, Figures& figures) {
  for (const auto& [label, of] : state.statistics->figures())
    figures["label_" + structure_name(label) + "_ml"] = of.ml;
}

void require_editable(const CaseState& state) {
  require_part(state, Part::image, "Import a CT first: labels are drawn on it");
  if (state.labels)
    require_same_grid(state.labels->voxels.grid(), state.image->grid, "the case's labels and its image");
}

/// What a file says of its labels, by the labels that they become.
Review review_of(const LabelFile& file, const LabelCodes& codes) {
  Review review;
  for (const LabelInfo& info : file.infos) {
    if (!codes.empty() && !codes.contains(info.code)) continue;  // it becomes background
    const ReviewState state = review_state(info.status);
    const auto [known, is_new] = review.emplace(codes.empty() ? info.code : codes.at(info.code), state);
    // Of several that become one label, all have to be looked at.
    if (!is_new) known->second = std::min(known->second, state);
  }
  std::erase_if(review, [](const auto& one) { return one.second == ReviewState::not_started; });
  return review;
}

Applied stepped(const CaseState& state, bool back) {
  const editing::History history = history_of(state);
  if (!state.labels || !(back ? history.can_undo() : history.can_redo()))
    throw InputError("labels", "history", back ? "there is no step to undo" : "there is no step to redo",
                     back ? "Edit the labels first" : "Only what was undone last can be redone");
  Applied applied;
  applied.state = state;
  const editing::History::Step& step = back ? history.undo_step() : history.redo_step();
  put_review(applied.state, review_after(review_of(state), labels_touched(step.changes)));
  auto [labels, then] = back ? history.undo(*state.labels) : history.redo(*state.labels);
  put_labels(applied.state, std::move(labels), std::move(then));
  return applied;
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const ImportLabels& command,
                               const RunContext& context) {
  context.progress(0.0, "labels.read");
  const LabelFile file = read_labels(command.path);
  if (state.image) require_same_grid(file.voxels.grid(), state.image->grid, command.path.string());
  if (context.cancelled()) return {};
  Applied applied;
  applied.state = state;
  LabelMap labels = command.codes.empty() ? LabelMap{file.voxels, file.infos}
                                          : recode(file, command.codes, command.path.string());
  const Review review = review_of(file, command.codes);
  replace_labels(applied.state, std::move(labels), {"import_labels", 0, 0.0});
  put_review(applied.state, review);
  report_labels(applied.state, applied.figures);
  if (!applied.figures.contains("label_parenchyma_ml"))
    throw InputError(command.path.string(), "labels", "none of them is the liver's parenchyma",
                     "Say which code means what with --codes FILE (see 'glisson model --help')");
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const ExportLabels& command, const RunContext&) {
  require_part(state, Part::labels, "Segment the CT or import labels first");
  write_labels(command.path, state.labels->voxels, reviewed_infos(state));
  return Applied{state, {}, {}};
}

Cancellable<Applied> apply_one(const CaseState& state, const Segment& command, const RunContext& context) {
  require_part(state, Part::image, "Import a CT first");
  require_part(state, Part::seeds, "Click seeds in the liver first, or give --seeds FILE");
  const segmentation::SegmentationOptions& options = command.options;
  auto segmented = segmentation::segment(*state.image, *state.seeds, options, context,
                                         command.keeps_labels() ? state.labels.get() : nullptr, command.show);
  if (!segmented) return {};
  Applied applied;
  applied.state = state;
  applied.notes = segmented->report.notes;
  const std::set<Label> touched =
      replace_labels(applied.state, std::move(segmented->labels), {"segment", 0, 0.0});
  // What a machine made is there to be looked at.
  Review review = review_of(state);
  for (const Label label : touched) review[label] = ReviewState::to_review;
  put_review(applied.state, review);
  report_labels(applied.state, applied.figures);
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const EditLabels& command, const RunContext& context) {
  require_editable(state);
  const LabelMap before = labels_of(state);
  std::optional<editing::Edited> edited;
  if (state.preview && state.preview->base == state.labels && state.preview->edit == command.edit)
    edited = state.preview->result;
  else
    edited = editing::apply_edit(before, *state.image, command.edit, context);
  if (!edited) return {};
  Applied applied;
  applied.state = state;
  applied.figures["voxels_changed"] = static_cast<double>(edited->voxels_changed);
  applied.notes = edited->notes;
  if (edited->voxels_changed == 0) {
    // The labels stay the same edition: a model made of them is not out of date.
    applied.state.preview = nullptr;
    return applied;
  }
  const std::set<Label> touched = step_to(applied.state, before, std::move(edited->labels),
                                          editing::step_name(command.edit), command.gesture);
  put_review(applied.state, review_after(review_of(state), touched));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const PreviewEdit& command,
                               const RunContext& context) {
  Applied applied;
  applied.state = state;
  applied.state.preview = nullptr;
  if (!command.edit) return applied;
  require_editable(state);
  auto edited = editing::apply_edit(labels_of(state), *state.image, *command.edit, context);
  if (!edited) return {};
  applied.figures["voxels_changed"] = static_cast<double>(edited->voxels_changed);
  applied.notes = edited->notes;
  applied.state.preview =
      std::make_shared<const EditPreview>(EditPreview{*command.edit, state.labels, std::move(*edited)});
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const UndoLabels&, const RunContext&) {
  return stepped(state, true);
}

Cancellable<Applied> apply_one(const CaseState& state, const RedoLabels&, const RunContext&) {
  return stepped(state, false);
}

Cancellable<Applied> apply_one(const CaseState& state, const SetReview& command, const RunContext&) {
  Applied applied;
  applied.state = state;
  Review review = review_of(state);
  review[command.label] = command.state;
  put_review(applied.state, review);
  return applied;
}

}  // namespace glisson::engine
