// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_modality.h"

#include <memory>
#include <utility>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/source.h"
#include "glisson/volume/plausibility.h"
#include "told_modality.h"

namespace glisson::engine {

CommandTraits SetModality::traits() const {
  return {.code = "set_modality",
          .reads = {part::image, part::source},
          .writes = {part::image},
          .needs = {part::image}};
}

Cancellable<Applied> SetModality::apply(const CaseState& state, const RunContext&) const {
  const Image& former = *state[part::image];
  const auto& source = state[part::source];
  require_modality_untold(former, source && !source->empty(), modality, {});
  if (modality == former.modality) return Applied{state};
  Image image = former;
  image.modality = modality;
  Applied applied{state, {}, image_doubts(image)};
  applied.state[part::image] = std::make_shared<const Image>(std::move(image));
  return applied;
}

}  // namespace glisson::engine
