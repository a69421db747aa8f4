// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/import_labels.h"

#include <utility>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/engine/parts/source.h"
#include "glisson/patient/label_import.h"
#include "label_steps.h"
#include "orientation_note.h"
#include "steps/import_labels.h"

namespace glisson::engine {
namespace {

LabelPlace place_of(const CaseState& state) {
  LabelPlace place;
  if (const auto& image = state[part::image]) place.grid = &image->grid;
  if (const auto& source = state[part::source]) place.frame_of_reference_uid = source->frame_of_reference_uid;
  return place;
}

/// The labels with their figures, their review and what was told of them.
Applied with_imported(const CaseState& state, ImportedLabels imported) {
  Applied applied{state, {}, imported.notes};
  replace_labels(applied.state, {std::move(imported.labels), std::move(imported.notes)},
                 step::import_labels.name());
  put_review(applied.state, imported.review);
  applied.figures = label_figures(applied.state);
  return applied;
}

}  // namespace

CommandTraits ImportLabels::traits() const {
  return {.code = "import_labels",
          .reads = {part::image, part::source, part::locks},
          .writes = labels_and_review(),
          .notice = Notice::files};
}

Cancellable<Applied> ImportLabels::apply(const CaseState& state, const RunContext& context) const {
  auto imported = import_labels(path, codes, left_liver, place_of(state), context);
  if (!imported) return {};
  auto notes = orientation_notes(atlas.get(), imported->labels, context.part(0.5, 1.0));
  if (!notes) return {};
  imported->notes.insert(imported->notes.end(), notes->begin(), notes->end());
  return with_imported(state, std::move(*imported));
}

}  // namespace glisson::engine
