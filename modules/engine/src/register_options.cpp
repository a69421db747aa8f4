// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/register_options.h"

#include <utility>

#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/tissue.h"

namespace glisson::engine {

registration::RegisterOptions options_of(const CaseState& state, registration::RegisterOptions options) {
  options.landmarks_are_placed = state[part::landmarks] != nullptr;
  if (options.tissue.empty()) options.tissue = tissue_of(state, !options.materials);
  return options;
}

registration::RegisterOptions options_with_looks(const CaseState& state,
                                                 registration::RegisterOptions options) {
  options = options_of(state, std::move(options));
  for (const auto& look : looks_to_join(state)) options.looks.push_back(*look);
  return options;
}

}  // namespace glisson::engine
