// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/step_kind.h"

#include <algorithm>
#include <string>

#include "built_in_steps.h"

namespace glisson::engine {
namespace {

/// Kinds that were registered besides the built-in ones. In a function: others register before main().
std::vector<const StepKind*>& registered() {
  static std::vector<const StepKind*> kinds;
  return kinds;
}

}  // namespace

editing::StepName StepKind::name(Label label) const { return {std::string(code), label, 0.0}; }

RegisteredStepKind::RegisteredStepKind(const StepKind& kind) { registered().push_back(&kind); }

const std::vector<const StepKind*>& step_kinds() {
  static const std::vector<const StepKind*> kKinds = [] {
    std::vector<const StepKind*> kinds = built_in_steps();
    kinds.insert(kinds.end(), registered().begin(), registered().end());
    std::ranges::sort(kinds, {}, [](const StepKind* kind) { return kind->code; });
    return kinds;
  }();
  return kKinds;
}

StepKind::Work work_of(const editing::StepName& step) {
  const auto& kinds = step_kinds();
  const auto known = std::ranges::find(kinds, step.code, [](const StepKind* kind) { return kind->code; });
  return known == kinds.end() ? StepKind::Work::by_hand : (*known)->work;
}

}  // namespace glisson::engine
