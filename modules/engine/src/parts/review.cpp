// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/review.h"

#include <nlohmann/json.hpp>

#include "glisson/engine/parts/labels.h"
#include "same_value.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder&) {
  json states = json::array();
  for (const auto& [label, review] : *state[part::review]) states.push_back({label, slicer_status(review)});
  return {{"states", states}};
}

void load(CaseState& state, const json& entry, const CaseFolder&) {
  Review review;
  for (const json& state_of_one : entry.at("states"))
    review[state_of_one.at(0).get<Label>()] = review_state(state_of_one.at(1).get<std::string>());
  state[part::review] = std::make_shared<const Review>(std::move(review));
}

}  // namespace

const PartOf<Review> part::review{{.code = "review",
                                   .made_of = {part::labels},
                                   .remedy = "Look at the labels and say so first",
                                   .save = save,
                                   .load = load,
                                   .same = same_value(part::review),
                                   .stands_alone = true,
                                   .is_input = false}};

}  // namespace glisson::engine
