// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/build_model.h"

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/review.h"
#include "model_figures.h"
#include "orientation_note.h"

namespace glisson::engine {
namespace {

/// Null: none, or another one than they were drawn on.
const Image* image_of_labels(const CaseState& state) {
  const Image* image = state[part::image].get();
  const bool is_theirs =
      image != nullptr && !image->empty() && image->grid.same_as(state[part::labels]->voxels.grid());
  return is_theirs ? image : nullptr;
}

}  // namespace

CommandTraits BuildModel::traits() const {
  return {.code = "build_model",
          .reads = {part::image, part::labels},
          .writes = {part::model},
          .needs = {part::labels}};
}

Cancellable<Applied> BuildModel::apply(const CaseState& state, const RunContext& context) const {
  auto built = model::build_from_labels(*state[part::labels], options, context.part(0.0, 0.95),
                                        image_of_labels(state));
  if (!built || !note_orientation(atlas.get(), *built, context.part(0.95, 1.0))) return {};
  Applied applied = with_model(state, std::move(*built));
  // Not in the model's own notes: a label may be approved later.
  for (std::string& note : unapproved_notes(state)) applied.notes.push_back(std::move(note));
  return applied;
}

}  // namespace glisson::engine
