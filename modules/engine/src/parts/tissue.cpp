// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/tissue.h"

#include <nlohmann/json.hpp>

#include "glisson/core/error.h"

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
    throw InputError((folder.path / "case.json").string(), std::string("tissue, ") + failure.field(),
                     failure.problem(), failure.remedy());
  }
}

bool same(const CaseState& written, const CaseState& read) {
  return *written[part::tissue] == *read[part::tissue];
}

}  // namespace

const PartOf<fem::Tissue> part::tissue{{.code = "tissue",
                                        .remedy = "Say how stiff the liver or a lesion is first (Model)",
                                        .save = save,
                                        .load = load,
                                        .same = same,
                                        .stands_alone = true}};

fem::Tissue tissue_of(const CaseState& state, bool with_parenchyma) {
  fem::Tissue tissue;
  if (state[part::tissue]) tissue = *state[part::tissue];
  if (!with_parenchyma) tissue.parenchyma.reset();
  return tissue;
}

}  // namespace glisson::engine
