// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/register_options.h"

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"

namespace glisson::engine {

namespace {

/// Of a model that ends with the image, inside the organ. A cut of less than 10 cm^2 is a cap of 2 mm on a
/// dome of 8 cm: about a slice.
std::optional<std::string> cut_doubt(const model::BuiltModel& built) {
  constexpr long kSlice = 10;
  const std::string code = "liver.cut_off ";
  for (const std::string& note : built.report.notes)
    if (note.starts_with(code) && std::strtol(note.c_str() + code.size(), nullptr, 10) >= kSlice)
      return "organ_cut " + note.substr(code.size());
  return {};
}

}  // namespace

registration::RegisterOptions options_of(const CaseState& state, registration::RegisterOptions options) {
  options.landmarks_are_placed = state[part::landmarks] != nullptr;
  if (options.tissue.empty()) options.tissue = tissue_of(state, !options.materials);
  if (auto cut = cut_doubt(*state[part::model])) options.model_doubts.push_back(std::move(*cut));
  return options;
}

registration::RegisterOptions options_with_looks(const CaseState& state,
                                                 registration::RegisterOptions options) {
  options = options_of(state, std::move(options));
  for (const auto& look : looks_to_join(state)) options.looks.push_back(*look);
  return options;
}

}  // namespace glisson::engine
