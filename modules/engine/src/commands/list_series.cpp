// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/list_series.h"

namespace glisson::engine {

CommandTraits ListSeries::traits() const { return {.code = "list_series", .notice = Notice::files}; }

Cancellable<Applied> ListSeries::apply(const CaseState& state, const RunContext& context) const {
  auto series = list_series(path, context);
  if (!series) return {};
  Applied applied{state};
  applied.result = std::make_shared<const Result>(std::move(*series));
  return applied;
}

}  // namespace glisson::engine
