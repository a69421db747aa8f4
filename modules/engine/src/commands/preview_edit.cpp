// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/preview_edit.h"

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/preview.h"
#include "label_steps.h"

namespace glisson::engine {
namespace {

Applied without_preview(const CaseState& state) {
  Applied applied{state};
  applied.state[part::preview] = nullptr;
  return applied;
}

Cancellable<EditPreview> preview_of(const CaseState& state, const editing::Edit& edit,
                                    const RunContext& context) {
  require_labels_fit_image(state);
  auto edited = editing::apply_edit(labels_or_none(state), *state[part::image], edit, context);
  if (!edited) return {};
  return EditPreview{edit, state[part::labels], std::move(*edited)};
}

}  // namespace

CommandTraits PreviewEdit::traits() const {
  return {.code = "preview_edit",
          .reads = {part::image, part::labels},
          .writes = {part::preview},
          .needs = edit ? Needs{part::image} : Needs{},
          .lane = edit ? Lane::work : Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> PreviewEdit::apply(const CaseState& state, const RunContext& context) const {
  if (!edit) return without_preview(state);
  auto preview = preview_of(state, *edit, context);
  if (!preview) return {};
  const editing::Edited& edited = preview->result;
  Applied applied{state, {{"voxels_changed", static_cast<double>(edited.voxels_changed)}}, edited.notes};
  applied.state[part::preview] = std::make_shared<const EditPreview>(std::move(*preview));
  return applied;
}

}  // namespace glisson::engine
