// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/propose_seeds.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/segmentation/propose_seeds.h"

namespace glisson::engine {
namespace {

/// @throws InputError the liver has seeds already.
segmentation::Seeds seeds_without_liver(const CaseState& state) {
  segmentation::Seeds seeds = state[part::seeds] ? *state[part::seeds] : segmentation::Seeds{};
  if (seeds.liver.rows() > 0)
    throw InputError("seeds", "liver", "has seeds already", "Delete them first, or add more by hand");
  return seeds;
}

}  // namespace

CommandTraits ProposeSeeds::traits() const {
  return {.code = "propose_seeds",
          .reads = {part::image, part::seeds},
          .writes = {part::seeds},
          .needs = {part::image}};
}

Cancellable<Applied> ProposeSeeds::apply(const CaseState& state, const RunContext& context) const {
  segmentation::Seeds seeds = seeds_without_liver(state);
  auto proposed = segmentation::propose_liver_seeds(*state[part::image], context);
  if (!proposed) return {};
  seeds.liver = std::move(*proposed);
  Applied applied{state, {{"proposed_seeds", static_cast<double>(seeds.liver.rows())}}, {"seeds.proposed"}};
  applied.state[part::seeds] = std::make_shared<const segmentation::Seeds>(std::move(seeds));
  return applied;
}

}  // namespace glisson::engine
