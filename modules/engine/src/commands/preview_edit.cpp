// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/preview_edit.h"

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/preview.h"
#include "label_steps.h"

namespace glisson::engine {

CommandTraits PreviewEdit::traits() const {
  return {.code = "preview_edit",
          .reads = {part::image, part::labels},
          .writes = {part::preview},
          .needs = edit ? Needs{part::image} : Needs{},
          .lane = edit ? Lane::work : Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> PreviewEdit::apply(const CaseState& state, const RunContext& context) const {
  Applied applied{state};
  applied.state[part::preview] = nullptr;
  if (!edit) return applied;
  require_labels_fit_image(state);
  auto edited = editing::apply_edit(labels_or_none(state), *state[part::image], *edit, context);
  if (!edited) return {};
  applied.figures["voxels_changed"] = static_cast<double>(edited->voxels_changed);
  applied.notes = edited->notes;
  applied.state[part::preview] =
      std::make_shared<const EditPreview>(EditPreview{*edit, state[part::labels], std::move(*edited)});
  return applied;
}

}  // namespace glisson::engine
