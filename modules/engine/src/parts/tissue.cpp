// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/tissue.h"

#include <nlohmann/json.hpp>

#include "case_manifest.h"
#include "glisson/core/error.h"
#include "same_value.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

constexpr const char* kField = "stiffness";

json save(const CaseState& state, const CaseFolder&) {
  return {{kField, fem::tissue_list(*state[part::tissue])}};
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  try {
    state[part::tissue] =
        std::make_shared<const fem::Tissue>(fem::tissue_from(entry.at(kField).get<std::string>()));
  } catch (const InputError& failure) {
    throw InputError((folder.path / kCaseFile).string(), std::string("tissue, ") + failure.field(),
                     failure.problem(), failure.remedy());
  }
}

}  // namespace

const PartOf<fem::Tissue> part::tissue{{.code = "tissue",
                                        .remedy = "Say how stiff the liver or a lesion is first (Model)",
                                        .save = save,
                                        .load = load,
                                        .same = same_value(part::tissue),
                                        .stands_alone = true}};

fem::Tissue tissue_of(const CaseState& state, bool with_parenchyma) {
  fem::Tissue tissue;
  if (state[part::tissue]) tissue = *state[part::tissue];
  if (!with_parenchyma) tissue.parenchyma.reset();
  return tissue;
}

}  // namespace glisson::engine
