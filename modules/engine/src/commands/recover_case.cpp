// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/recover_case.h"

#include <utility>

#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/keeping.h"

namespace glisson::engine {
namespace {

/// Where the case stands that the copy is of, held if it can be.
std::shared_ptr<Keeping> keeping_of(const Recoverable& copy, const Keeping* before) {
  auto keeping = std::make_shared<Keeping>();
  keeping->folder = case_place(copy.of);
  keeping->edition = copy.edition;
  if (std::filesystem::exists(keeping->folder)) hold(*keeping, before);
  return keeping;
}

/// The place of the case that the copy is of, and who else has it.
void keep(Applied& applied, const Recoverable& copy, const Keeping* before) {
  const auto keeping = keeping_of(copy, before);
  if (keeping->writer && keeping->writer->is_there)
    applied.notes.push_back("case.open_for_reading " + keeping->writer->told());
  applied.state[part::keeping] = keeping;
}

}  // namespace

CommandTraits RecoverCase::traits() const {
  return {.code = "recover_case", .writes = Parts::all(), .notice = Notice::files};
}

Cancellable<Applied> RecoverCase::apply(const CaseState& before, const RunContext& context) const {
  Applied applied;
  auto opened = open_case(copy.copy, context, &applied.notes);
  if (!opened) return {};
  applied.state = std::move(*opened);
  applied.state.path = copy.of;
  applied.keeps_stamps = true;
  if (!copy.of.empty()) keep(applied, copy, before[part::keeping].get());
  return applied;
}

}  // namespace glisson::engine
