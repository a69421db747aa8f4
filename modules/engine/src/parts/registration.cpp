// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/registration.h"

#include <nlohmann/json.hpp>

#include "case_files.h"
#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/registration/refusal.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

constexpr LengthUnit kUnit = LengthUnit::millimetre;

json save(const CaseState& state, const CaseFolder& folder) {
  const Registration& registration = *state[part::registration];
  write_registration(folder.path / "registration.vtu", state[part::model]->model, registration, kUnit);
  return {{"termination", static_cast<int>(registration.termination)},
          {"plateaus", registration.plateaus},
          {"steps", registration.steps},
          {"residual_mm", 1e3 * registration.residual},
          {"seen_share", registration.seen_share},
          {"doubts", registration.doubts}};
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  if (!state[part::model])
    throw InputError((folder.path / "case.json").string(), "registration",
                     "there is no model that it belongs to", "Restore the case from a copy");
  Registration registration =
      read_registration(folder.path / "registration.vtu", state[part::model]->model, kUnit);
  registration.termination = static_cast<Termination>(entry.at("termination").get<int>());
  registration.plateaus = entry.at("plateaus");
  registration.steps = entry.at("steps");
  registration.residual = 1e-3 * entry.at("residual_mm").get<double>();
  registration.seen_share = entry.value("seen_share", 0.0);  // cases of before have none
  registration.doubts = entry.at("doubts").get<std::vector<std::string>>();
  state[part::registration] = std::make_shared<const Registration>(std::move(registration));
}

/// One of a former model has other nodes, is of no use any more, and is not written.
bool is_of_its_model(const CaseState& state) {
  const auto& registration = state[part::registration];
  return registration && state[part::model] &&
         registration->nodes_in_camera.rows() == state[part::model]->model.mesh.vertex_count();
}

bool is_refused(const CaseState& state) { return registration::is_refused(*state[part::registration]); }

bool same(const CaseState& written, const CaseState& read) {
  return same_points(read[part::registration]->nodes_in_camera, written[part::registration]->nodes_in_camera);
}

}  // namespace

const PartOf<Registration> part::registration{
    {.code = "registration",
     .made_of = {part::model, part::landmarks, part::cloud, part::earlier_looks},
     .remedy = "Register the model first",
     .files = {"registration.vtu"},
     .save = save,
     .load = load,
     .same = same,
     .is_savable = is_of_its_model,
     .is_refused = is_refused,
     .refused_remedy = "Register again with a better cloud, or "
                       "accept it knowing its doubts"}};

}  // namespace glisson::engine
