// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/import_surfaces.h"

#include "glisson/engine/parts/model.h"
#include "model_figures.h"
#include "orientation_note.h"

namespace glisson::engine {

CommandTraits ImportSurfaces::traits() const {
  return {.code = "import_surfaces", .writes = {part::model}, .notice = Notice::files};
}

Cancellable<Applied> ImportSurfaces::apply(const CaseState& state, const RunContext& context) const {
  const model::SurfaceSet surfaces = model::read_surfaces(path, unit, left_liver);
  auto built = model::build_from_surfaces(surfaces, options, context.part(0.0, 0.95));
  if (!built || !note_orientation(atlas.get(), *built, context.part(0.95, 1.0))) return {};
  return with_model(state, std::move(*built));
}

}  // namespace glisson::engine
