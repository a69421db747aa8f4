// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/keep_copy.h"

#include <nlohmann/json.hpp>

#include "../recovery_copy.h"
#include "glisson/core/json_file.h"
#include "glisson/core/time_text.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/keeping.h"

namespace glisson::engine {
namespace {

/// The former copy is none from now on where it is of another case: the new one must never stand under its
/// name.
void disown_former(const std::filesystem::path& said, const std::string& of) {
  try {
    if (read_json(said).at("of") == of) return;
  } catch (const std::exception&) {  // there is none, or none that could be offered
  }
  std::error_code ignored;
  std::filesystem::remove(said, ignored);
}

/// Of which case the copy beside it is, and of which edition.
void say(const std::filesystem::path& said, const std::string& of, const Keeping* keeping) {
  write_json(said, {{"of", of},
                    {"edition", keeping != nullptr ? keeping->edition : std::string()},
                    {"saved", local_time_text("%Y-%m-%d %H:%M")}});
}

}  // namespace

CommandTraits KeepCopy::traits() const {
  CommandTraits traits{.code = "keep_copy", .notice = Notice::quiet};
  for (const Part part : all_parts())
    if (part.type().is_saved()) traits.reads.add(part);
  return traits;
}

Cancellable<Applied> KeepCopy::apply(const CaseState& state, const RunContext& context) const {
  SavedImage none;
  SavedImage& known = saved ? *saved : none;
  if (state[part::keeping] && !known.knows(state)) known = state[part::keeping]->image;
  const std::string of = state.path.empty() ? "" : case_place(state.path).string();
  disown_former(folder / kSaidName, of);
  if (!save_case(folder / kCopyName, state, context, known)) return {};
  say(folder / kSaidName, of, state[part::keeping].get());
  return Applied{state};
}

}  // namespace glisson::engine
