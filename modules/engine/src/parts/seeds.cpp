// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/seeds.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "case_files.h"
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

bool same(const CaseState& written, const CaseState& read) {
  const segmentation::Seeds &a = *written[part::seeds], &b = *read[part::seeds];
  for (const auto clicks :
       {&segmentation::Seeds::liver, &segmentation::Seeds::portal_vein, &segmentation::Seeds::hepatic_veins,
        &segmentation::Seeds::vena_cava, &segmentation::Seeds::gallbladder, &segmentation::Seeds::background})
    if (!same_points(a.*clicks, b.*clicks)) return false;
  if (a.lesions.size() != b.lesions.size()) return false;
  for (std::size_t i = 0; i < a.lesions.size(); ++i)
    if (!same_points(a.lesions[i], b.lesions[i]) ||
        std::abs(a.lesion_diameter_mm(i) - b.lesion_diameter_mm(i)) > 1e-6)
      return false;
  return true;
}

}  // namespace

const PartOf<segmentation::Seeds> part::seeds{
    {.code = "seeds",
     .made_of = {part::image},
     .remedy = "Click seeds in the liver first, or give --seeds FILE",
     .files = {"seeds.json"},
     .save = save,
     .load = load,
     .same = same}};

}  // namespace glisson::engine
