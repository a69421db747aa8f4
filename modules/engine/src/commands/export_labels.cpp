// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/export_labels.h"

#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"
#include "glisson/engine/review.h"
#include "glisson/volume/io.h"

namespace glisson::engine {

CommandTraits ExportLabels::traits() const {
  return {.code = "export_labels",
          .reads = {part::labels, part::review},
          .needs = {part::labels},
          .notice = Notice::files};
}

Cancellable<Applied> ExportLabels::apply(const CaseState& state, const RunContext&) const {
  write_labels(path, state[part::labels]->voxels, reviewed_infos(state));
  return Applied{state};
}

}  // namespace glisson::engine
