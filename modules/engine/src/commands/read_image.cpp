// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/read_image.h"

#include <memory>
#include <utility>

namespace glisson::engine {

CommandTraits ReadImage::traits() const { return {.code = "read_image", .notice = Notice::files}; }

Cancellable<Applied> ReadImage::apply(const CaseState& state, const RunContext& context) const {
  auto scan = read_scan(path, context, series);
  if (!scan) return {};
  Applied applied{state};
  applied.result = std::make_shared<const Result>(std::move(*scan));
  return applied;
}

}  // namespace glisson::engine
