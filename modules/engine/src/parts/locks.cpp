// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/locks.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "same_value.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder&) { return {{"labels", *state[part::locks]}}; }

void load(CaseState& state, const json& entry, const CaseFolder&) {
  state[part::locks] = std::make_shared<const std::set<Label>>(entry.at("labels").get<std::set<Label>>());
}

}  // namespace

std::set<Label> locked_in(const CaseState& state) {
  return state[part::locks] ? *state[part::locks] : std::set<Label>();
}

std::vector<Label> with_locks(std::vector<Label> locked, const CaseState& state) {
  for (const Label label : locked_in(state))
    if (std::ranges::find(locked, label) == locked.end()) locked.push_back(label);
  return locked;
}

const PartOf<std::set<Label>> part::locks{{.code = "locks",
                                           .remedy = "Lock a label first",
                                           .save = save,
                                           .load = load,
                                           .same = same_value(part::locks),
                                           .stands_alone = true,
                                           .is_input = false}};

}  // namespace glisson::engine
