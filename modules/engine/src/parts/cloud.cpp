// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/cloud.h"

#include <nlohmann/json.hpp>

#include "case_files.h"
#include "case_stereo.h"
#include "glisson/core/error.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/rig.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

constexpr LengthUnit kUnit = LengthUnit::millimetre;

json save(const CaseState& state, const CaseFolder& folder) {
  write_cloud(folder.path / "cloud.ply", *state[part::cloud], kUnit);
  const auto& points = state[part::points];
  if (points) write_points(folder.path, state, *points);
  return {{"has_points", points != nullptr}};
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  const bool read = or_lost(folder, "case.cloud_lost", [&] {
    state[part::cloud] = std::make_shared<const LabelledCloud>(read_cloud(folder.path / "cloud.ply", kUnit));
  });
  if (!read || !entry.value("has_points", false)) return;  // imported, or of a case of before
  or_lost(folder, "case.points_lost", [&] { state[part::points] = read_points(folder.path, state); });
}

bool same(const CaseState& written, const CaseState& read) {
  const auto &a = written[part::points], &b = read[part::points];
  return same_points(read[part::cloud]->points, written[part::cloud]->points) &&
         (a != nullptr) == (b != nullptr) && (!a || same_pair_points(*b, *a));
}

}  // namespace

const PartOf<PairPoints> part::points{{.code = "points"}};
const PartOf<LabelledCloud> part::cloud{{.code = "cloud",
                                         .made_of = {part::rig, part::frame, part::regions},
                                         .remedy = "Reconstruct or import a cloud first",
                                         .files = {"cloud.ply", "points/*.ply", "points/*.json"},
                                         .save = save,
                                         .load = load,
                                         .same = same,
                                         .companions = {&part::points}}};

}  // namespace glisson::engine
