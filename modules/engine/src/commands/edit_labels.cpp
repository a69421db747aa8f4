// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/edit_labels.h"

#include <optional>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/preview.h"
#include "label_steps.h"

namespace glisson::engine {

CommandTraits EditLabels::traits() const {
  return {.code = "edit_labels",
          .reads = labels_and_review() | Parts{part::image},
          .writes = labels_and_review(),
          .needs = {part::image},
          .lane = editing::is_local(edit.tool) ? Lane::edits : Lane::work,
          .notice = Notice::quiet};
}

Cancellable<Applied> EditLabels::apply(const CaseState& state, const RunContext& context) const {
  require_labels_fit_image(state);
  const LabelMap before = labels_or_none(state);
  const auto& preview = state[part::preview];
  std::optional<editing::Edited> edited;
  const bool is_of_now = preview && stage_state(state, part::preview) == StageState::current;
  if (is_of_now && preview->base == state[part::labels] && preview->edit == edit)
    edited = preview->result;
  else
    edited = editing::apply_edit(before, *state[part::image], edit, context);
  if (!edited) return {};
  Applied applied{state};
  applied.figures["voxels_changed"] = static_cast<double>(edited->voxels_changed);
  applied.notes = edited->notes;
  if (edited->voxels_changed == 0)
    // The labels stay the same edition: a model made of them is not out of date.
    applied.state[part::preview] = nullptr;
  else
    put_edited_labels(applied.state, before, std::move(edited->labels), editing::step_name(edit), gesture);
  return applied;
}

}  // namespace glisson::engine
