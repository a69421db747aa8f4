// SPDX-License-Identifier: GPL-3.0-or-later
#include "apply_parts.h"
#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"

namespace glisson::engine {
namespace {

Cancellable<Applied> apply_one(const CaseState&, const OpenCase& command, const RunContext& context) {
  Applied applied;
  auto opened = open_case(command.path, context, &applied.notes);
  if (!opened) return {};
  applied.state = std::move(*opened);
  applied.keeps_stamps = true;
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const SaveCase& command, const RunContext& context) {
  Applied applied;
  applied.state = state;
  const std::filesystem::path path = command.path.empty() ? state.path : command.path;
  if (path.empty())
    throw InputError("case", "path", "the case has never been saved",
                     "Choose a folder NAME.glisson to save it to");
  if (!save_case(path, state, context)) return {};
  applied.state.path = path;
  return applied;
}

/// Tracking and trials are the engine's own (see Engine::Impl::perform); they have no place in a pure
/// function.
Cancellable<Applied> apply_one(const CaseState&, const StartTracking&, const RunContext&) {
  throw PreconditionError("tracking is started by the engine");
}
Cancellable<Applied> apply_one(const CaseState&, const StopTracking&, const RunContext&) {
  throw PreconditionError("tracking is stopped by the engine");
}
Cancellable<Applied> apply_one(const CaseState&, const StartTrial&, const RunContext&) {
  throw PreconditionError("a trial is started by the engine");
}
Cancellable<Applied> apply_one(const CaseState&, const StopTrial&, const RunContext&) {
  throw PreconditionError("a trial is stopped by the engine");
}

}  // namespace

void require_part(const CaseState& state, Part part, const char* remedy) {
  if (!state.has(part)) throw InputError("case", std::string(part_code(part)), "there is none yet", remedy);
}

Cancellable<Applied> apply(const CaseState& state, const Command& command, const RunContext& context) {
  return std::visit([&](const auto& one) { return apply_one(state, one, context); }, command);
}

}  // namespace glisson::engine
