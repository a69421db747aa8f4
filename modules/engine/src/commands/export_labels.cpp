// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/export_labels.h"

#include "glisson/engine/label_export.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"
#include "glisson/engine/parts/source.h"

namespace glisson::engine {

CommandTraits ExportLabels::traits() const {
  return {.code = "export_labels",
          .reads = {part::labels, part::review, part::image, part::source},
          .needs = {part::labels},
          .notice = Notice::files};
}

Cancellable<Applied> ExportLabels::apply(const CaseState& state, const RunContext&) const {
  write_case_labels(path, state);
  return Applied{state};
}

}  // namespace glisson::engine
