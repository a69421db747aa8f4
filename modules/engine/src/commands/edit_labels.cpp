// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/edit_labels.h"

#include <optional>
#include <vector>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/engine/parts/preview.h"
#include "label_steps.h"

namespace glisson::engine {
namespace {

/// What the edit makes of the labels: the preview where it shows this edit of these labels.
Cancellable<editing::Edited> edited(const CaseState& state, const LabelMap& before, const editing::Edit& edit,
                                    const RunContext& context) {
  const auto& preview = state[part::preview];
  const bool is_of_now = preview && stage_state(state, part::preview) == StageState::current;
  if (is_of_now && preview->base == state[part::labels] && preview->edit == edit) return preview->result;
  return editing::apply_edit(before, *state[part::image], edit, context);
}

editing::Edit allowed(editing::Edit edit, const CaseState& state) {
  edit.region.locked = with_locks(std::move(edit.region.locked), state);
  return edit;
}

/// Where nothing changes the labels stay the same edition: a model made of them is not out of date.
void put(CaseState& state, const LabelMap& before, const EditLabels& command, editing::Edited made) {
  if (made.voxels_changed == 0)
    state[part::preview] = nullptr;
  else
    put_edited_labels(state, before, {std::move(made.labels), kept_notes(state)},
                      editing::step_name(command.edit), command.gesture);
}

}  // namespace

CommandTraits EditLabels::traits() const {
  return {.code = "edit_labels",
          .reads = labels_and_review() | Parts{part::image, part::locks},
          .writes = labels_and_review(),
          .needs = {part::image},
          .lane = editing::is_local(edit.tool) ? Lane::edits : Lane::work,
          .notice = Notice::quiet};
}

Cancellable<Applied> EditLabels::apply(const CaseState& state, const RunContext& context) const {
  require_labels_fit_image(state);
  const LabelMap before = labels_or_none(state);
  auto made = edited(state, before, allowed(edit, state), context);
  if (!made) return {};
  Applied applied{state, {{"voxels_changed", static_cast<double>(made->voxels_changed)}}, made->notes};
  put(applied.state, before, *this, std::move(*made));
  return applied;
}

}  // namespace glisson::engine
