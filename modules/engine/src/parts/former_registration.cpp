// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/former_registration.h"

#include <nlohmann/json.hpp>

#include "case_files.h"
#include "glisson/core/error.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/tissue.h"
#include "registration_entry.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

constexpr const char* kFile = "former_registration.vtu";

FormerRegistration of(const CaseState& state, std::shared_ptr<const Registration> registration) {
  return {std::move(registration), state[part::model], state[part::landmarks],
          state[part::tissue],     state[part::cloud], state[part::earlier_looks]};
}

json save(const CaseState& state, const CaseFolder& folder) {
  return write_registration_entry(folder, kFile, *state[part::model],
                                  *state[part::former_registration]->registration);
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  or_lost(folder, "case.former_registration_lost", [&] {
    state[part::former_registration] = std::make_shared<const FormerRegistration>(
        of(state, read_registration_entry(folder, kFile, entry, state[part::model].get())));
  });
}

bool same(const CaseState& written, const CaseState& read) {
  return same_registration(*written[part::former_registration]->registration,
                           *read[part::former_registration]->registration);
}

}  // namespace

const PartOf<FormerRegistration> part::former_registration{
    {.code = "former_registration",
     .made_of = {part::model, part::landmarks, part::tissue, part::cloud, part::earlier_looks},
     .remedy = "Register once more first",
     .files = {kFile},
     .save = save,
     .load = load,
     .same = same,
     .is_savable = has_former_registration,
     .stands_alone = true,
     .is_input = false}};

bool has_former_registration(const CaseState& state) {
  const auto& former = state[part::former_registration];
  if (!former || !state[part::model]) return false;
  const FormerRegistration now = of(state, former->registration);
  return former->model == now.model && former->landmarks == now.landmarks && former->tissue == now.tissue &&
         former->cloud == now.cloud && former->looks == now.looks &&
         former->registration->nodes_in_camera.rows() == now.model->model.mesh.vertex_count();
}

void keep_former_registration(CaseState& made, const CaseState& before) {
  const bool stands = stage_state(before, part::registration) == StageState::current;
  made[part::former_registration] =
      stands ? std::make_shared<const FormerRegistration>(of(before, before[part::registration])) : nullptr;
}

Parts inputs_of_former_registration() {
  return {part::model, part::landmarks, part::tissue, part::cloud, part::earlier_looks, part::registration};
}

}  // namespace glisson::engine
