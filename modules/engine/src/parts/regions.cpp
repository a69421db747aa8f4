// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/regions.h"

#include <algorithm>
#include <cmath>
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

bool same_region(const stereo::Region& a, const stereo::Region& b) {
  constexpr double kPixels = 1e-6;
  const auto close = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return (p - q).cwiseAbs().maxCoeff() < kPixels;
  };
  return a.feature == b.feature && a.closed == b.closed && a.side == b.side &&
         (a.closed || std::abs(a.half_width_px - b.half_width_px) < kPixels) &&
         std::equal(a.polygon.begin(), a.polygon.end(), b.polygon.begin(), b.polygon.end(), close);
}

bool same(const CaseState& written, const CaseState& read) {
  const stereo::Regions &a = *written[part::regions], &b = *read[part::regions];
  return a.frame == b.frame && a.identity == b.identity &&
         std::equal(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(), same_region);
}

}  // namespace

const PartOf<stereo::Regions> part::regions{{.code = "regions",
                                             .made_of = {part::frame},
                                             .remedy = "Draw regions on the stereo pair first",
                                             .files = {"regions.json"},
                                             .save = save,
                                             .load = load,
                                             .same = same}};

}  // namespace glisson::engine
