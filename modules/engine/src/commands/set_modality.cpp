// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/set_modality.h"

#include <memory>
#include <utility>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/source.h"
#include "glisson/volume/plausibility.h"
#include "told_modality.h"

namespace glisson::engine {
namespace {

/// @throws InputError the image's own file has said another one.
void require_untold(const CaseState& state, Modality modality) {
  const auto& source = state[part::source];
  require_modality_untold(*state[part::image], source && !source->empty(), modality, {});
}

}  // namespace

CommandTraits SetModality::traits() const {
  return {.code = "set_modality",
          .reads = {part::image, part::source},
          .writes = {part::image},
          .needs = {part::image}};
}

Cancellable<Applied> SetModality::apply(const CaseState& state, const RunContext&) const {
  const Image& former = *state[part::image];
  require_untold(state, modality);
  if (modality == former.modality) return Applied{state};
  auto image = std::make_shared<Image>(former);
  image->modality = modality;
  Applied applied{state, {}, image_doubts(*image)};
  applied.state[part::image] = std::move(image);
  return applied;
}

}  // namespace glisson::engine
