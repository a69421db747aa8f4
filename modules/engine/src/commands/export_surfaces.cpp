// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/export_surfaces.h"

#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/surface_export.h"

namespace glisson::engine {

CommandTraits ExportSurfaces::traits() const {
  return {.code = "export_surfaces",
          .reads = {part::labels, part::model},
          .needs = {either(part::labels, part::model)},
          .notice = Notice::files};
}

Cancellable<Applied> ExportSurfaces::apply(const CaseState& state, const RunContext& context) const {
  Applied applied{state};
  const auto files = write_case_surfaces(folder, ending, state, context, applied.notes);
  if (!files) return {};
  applied.figures["surfaces_written"] = static_cast<double>(files->size());
  return applied;
}

}  // namespace glisson::engine
