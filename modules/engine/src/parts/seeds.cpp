// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/seeds.h"

#include <nlohmann/json.hpp>

#include "glisson/engine/parts/image.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder& folder) {
  segmentation::write_seeds(folder.path / "seeds.json", *state[part::seeds]);
  return json::object();
}

void load(CaseState& state, const json&, const CaseFolder& folder) {
  state[part::seeds] =
      std::make_shared<const segmentation::Seeds>(segmentation::read_seeds(folder.path / "seeds.json"));
}

}  // namespace

const PartOf<segmentation::Seeds> part::seeds{
    {.code = "seeds",
     .made_of = {part::image},
     .remedy = "Click seeds in the liver first, or give --seeds FILE",
     .files = {"seeds.json"},
     .save = save,
     .load = load}};

}  // namespace glisson::engine
