// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/open_case.h"

#include "glisson/engine/case_io.h"

namespace glisson::engine {

CommandTraits OpenCase::traits() const {
  return {.code = "open_case", .writes = Parts::all(), .notice = Notice::files};
}

Cancellable<Applied> OpenCase::apply(const CaseState&, const RunContext& context) const {
  Applied applied;
  auto opened = engine::open_case(path, context, &applied.notes);
  if (!opened) return {};
  applied.state = std::move(*opened);
  applied.keeps_stamps = true;
  applied.result = std::make_shared<const CaseOnDisk>(CaseOnDisk{editions(applied.state)});
  return applied;
}

}  // namespace glisson::engine
