// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/check.h"

#include <nlohmann/json.hpp>

#include "glisson/engine/parts/model.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder&) { return {{"is_right", state[part::check]->is_right}}; }

void load(CaseState& state, const json& entry, const CaseFolder&) {
  state[part::check] = std::make_shared<const ModelCheck>(ModelCheck{entry.at("is_right").get<bool>()});
}

bool same(const CaseState& written, const CaseState& read) {
  return written[part::check]->is_right == read[part::check]->is_right;
}

}  // namespace

const PartOf<ModelCheck> part::check{{.code = "check",
                                      .made_of = {part::model},
                                      .remedy = "Look at the model and say whether it is right first",
                                      .save = save,
                                      .load = load,
                                      .same = same}};

bool is_model_checked(const CaseState& state) {
  // Not stage_state(): what the model was made from may have gone on, the model is still the one looked at.
  const auto& check = state[part::check];
  if (!check || !check->is_right || !state[part::model]) return false;
  const auto& made_from = state.stamp(part::check).made_from;
  const auto of = made_from.find(part::model);
  return of != made_from.end() && of->second == state.stamp(part::model).revision;
}

}  // namespace glisson::engine
