// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/save_case.h"

#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"

namespace glisson::engine {

CommandTraits SaveCase::traits() const {
  CommandTraits traits{.code = "save_case", .notice = Notice::files};
  // The live view goes on beside it and is not saved.
  for (const Part part : all_parts())
    if (part.type().is_saved()) traits.reads.add(part);
  return traits;
}

Cancellable<Applied> SaveCase::apply(const CaseState& state, const RunContext& context) const {
  const std::filesystem::path place = path.empty() ? state.path : path;
  if (place.empty())
    throw InputError("case", "path", "the case has never been saved",
                     "Choose a folder NAME.glisson to save it to");
  if (!engine::save_case(place, state, context)) return {};
  Applied applied{state};
  applied.state.path = place;
  applied.result = std::make_shared<const CaseOnDisk>(CaseOnDisk{editions(state)});
  return applied;
}

}  // namespace glisson::engine
