// SPDX-License-Identifier: GPL-3.0-or-later
#include "stamps.h"

#include <map>

namespace glisson::engine {
namespace {

/// Of which editions of other parts a part was made that a command wrote.
std::map<Part, std::uint64_t> made_from(Part part, const CommandTraits& command, const CaseState& base) {
  std::map<Part, std::uint64_t> inputs;
  const PartSpec& spec = part.type().spec();
  if (spec.stands_alone) return inputs;
  if (command.reads.has(part)) {
    // What is only changed stays as old as it was: an edit does not make labels of a former CT current, nor a
    // model of former labels.
    inputs = base.stamp(part).made_from;
    for (const Part freed : spec.changed_frees_from) inputs.erase(freed);
  }
  for (const Part input : all_parts()) {
    if (input == part || !input.type().spec().is_input || !command.reads.has(input)) continue;
    // An input that was not there counts too (revision 0): when it comes, this part is stale.
    inputs.try_emplace(input, base.stamp(input).revision);
  }
  return inputs;
}

void keep_together(CaseState& state, const CaseState& base, const Parts& renewed) {
  for (const Part part : all_parts()) {
    if (!renewed.has(part)) continue;
    for (auto& [input, revision] : state.stamp(part).made_from)
      if (renewed.has(input) && revision == base.stamp(input).revision)
        revision = state.stamp(input).revision;
  }
}

}  // namespace

void take_over(CaseState& state, const CommandTraits& command, const CaseState& base, const CaseState& made,
               std::uint64_t& revision) {
  Parts renewed;
  for (const Part part : all_parts()) {
    if (!command.writes.has(part) || made.shares(part, base)) continue;
    state.take(part, made);
    Stamp stamp;
    if (state.has(part)) stamp = {++revision, made_from(part, command, base)};
    state.stamp(part) = stamp;
    renewed.add(part);
  }
  keep_together(state, base, renewed);
}

}  // namespace glisson::engine
