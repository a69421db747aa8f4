// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/register_options.h"

#include <string>
#include <utility>

#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/patient/cut_organ.h"

namespace glisson::engine {

registration::RegisterOptions options_of(const CaseState& state, registration::RegisterOptions options) {
  options.landmarks_are_placed = state[part::landmarks] != nullptr;
  if (options.tissue.empty()) options.tissue = tissue_of(state, !options.materials);
  // Less than 10 cm^2 is a cap of 2 mm on a dome of 8 cm: about a slice.
  constexpr long kSlice = 10;
  const long cut = told_cut(state[part::model]->report.notes);
  if (cut >= kSlice) options.model_doubts.push_back("organ_cut " + std::to_string(cut));
  return options;
}

registration::RegisterOptions options_with_looks(const CaseState& state,
                                                 registration::RegisterOptions options) {
  options = options_of(state, std::move(options));
  for (const auto& look : looks_to_join(state)) options.looks.push_back(*look);
  return options;
}

}  // namespace glisson::engine
