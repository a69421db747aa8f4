// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/registration.h"

#include <nlohmann/json.hpp>

#include "case_files.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/registration/refusal.h"
#include "registration_entry.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

constexpr const char* kFile = "registration.vtu";

json save(const CaseState& state, const CaseFolder& folder) {
  return write_registration_entry(folder, kFile, *state[part::model], *state[part::registration]);
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  state[part::registration] = read_registration_entry(folder, kFile, entry, state[part::model].get());
}

/// One of a former model has other nodes, is of no use any more, and is not written.
bool is_of_its_model(const CaseState& state) {
  const auto& registration = state[part::registration];
  return registration && state[part::model] &&
         registration->nodes_in_camera.rows() == state[part::model]->model.mesh.vertex_count();
}

bool is_refused(const CaseState& state) { return registration::is_refused(*state[part::registration]); }

bool same(const CaseState& written, const CaseState& read) {
  return same_registration(*written[part::registration], *read[part::registration]);
}

}  // namespace

const PartOf<Registration> part::registration{
    {.code = "registration",
     .made_of = {part::model, part::landmarks, part::tissue, part::cloud, part::earlier_looks},
     .remedy = "Register the model first",
     .files = {kFile},
     .save = save,
     .load = load,
     .same = same,
     .is_savable = is_of_its_model,
     .is_refused = is_refused,
     .refused_remedy = "Register again with a better cloud, or "
                       "accept it knowing its doubts"}};

}  // namespace glisson::engine
