// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas_member.h"

#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"

namespace glisson::engine {

atlas::Member atlas_member(const std::string& name, const CaseState& state) {
  require_parts(state, {part::model});
  Landmarks placed = state[part::landmarks] ? *state[part::landmarks] : Landmarks{};
  for (const atlas::Structure structure : atlas::kStructures) {
    const atlas::Proposal* one = proposal_of(state, structure);
    if (one == nullptr || one->decision != atlas::Decision::accepted) continue;
    if (structure == atlas::Structure::umbilical_notch) placed.umbilical_notch.resize(0, 3);
    if (structure == atlas::Structure::anterior_margin) placed.anterior_margin.resize(0, 3);
    if (structure == atlas::Structure::vena_cava) placed.vena_cava.resize(0, 3);
  }
  return atlas::member_of(name, state[part::model]->model, placed);
}

}  // namespace glisson::engine
