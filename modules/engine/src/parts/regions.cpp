// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/regions.h"

#include <nlohmann/json.hpp>

#include "glisson/engine/parts/frame.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder& folder) {
  stereo::write_regions(folder.path / "regions.json", *state[part::regions]);
  return json::object();
}

void load(CaseState& state, const json&, const CaseFolder& folder) {
  state[part::regions] =
      std::make_shared<const stereo::Regions>(stereo::read_regions(folder.path / "regions.json"));
}

}  // namespace

const PartOf<stereo::Regions> part::regions{{.code = "regions",
                                             .made_of = {part::frame},
                                             .remedy = "Draw regions on the stereo pair first",
                                             .files = {"regions.json"},
                                             .save = save,
                                             .load = load}};

}  // namespace glisson::engine
