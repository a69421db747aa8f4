// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/propose_landmarks.h"

#include <algorithm>
#include <utility>

#include "../review_step.h"
#include "glisson/atlas/transfer.h"
#include "glisson/core/error.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {
namespace {
using atlas::Structure;

atlas::Evidence evidence(const PatientModel& model) {
  for (const NamedSurface& surface : model.surfaces)
    if (surface.structure == structure::kParenchyma) return atlas::evidence_of(model);
  return {{}, model.landmarks.anterior_margin};
}

/// With what a person has placed, which beats what the model shows.
atlas::Evidence evidence(const CaseState& state) {
  atlas::Evidence all = evidence(state[part::model]->model);
  for (const Structure structure : {Structure::umbilical_notch, Structure::vena_cava})
    all.placed[structure] = marks_by_hand(state, structure);
  return with_own_ridge(state, std::move(all));
}

/// What becomes of landmarks that former proposals have left: what a person has moved stays with its
/// proposal, what was merely accepted is asked again. @param made takes over what stays. @return the case
/// with the landmarks that stay.
CaseState settle_former(const CaseState& state, atlas::Transfer& made) {
  CaseState after = state;
  for (const Structure structure : atlas::kStructures) {
    if (!rests_on_proposal(state, structure)) continue;
    const atlas::Proposal& former = *proposal_of(state, structure);
    const auto now = std::ranges::find(made.proposals, structure, &atlas::Proposal::structure);
    if (former.decision != atlas::Decision::moved)
      after = with_marks_alone(after, structure);
    else if (now != made.proposals.end())
      *now = former;
    else
      made.proposals.push_back(former);
  }
  return after;
}

/// The case with what is proposed now. What a person has moved before tells of the others.
CaseState settled(const CaseState& state, atlas::Transfer made) {
  CaseState after = settle_former(state, made);
  after[part::proposals] = std::make_shared<const atlas::Transfer>(std::move(made));
  propose_others_again(after);
  return after;
}

Figures figures_of(const atlas::Transfer& made) {
  Figures figures = {{"atlas_fit_mean_mm", 1e3 * made.mean_distance},
                     {"atlas_fit_max_mm", 1e3 * made.max_distance},
                     {"atlas_unusual", made.unusual}};
  for (const atlas::Proposal& one : made.proposals)
    figures["atlas_" + std::string(atlas::structure_code(one.structure)) + "_deviation_mm"] =
        1e3 * one.deviation();
  return figures;
}

}  // namespace

const TriangleMesh& fine_liver(const PatientModel& model) {
  for (const NamedSurface& surface : model.surfaces)
    if (surface.structure == structure::kParenchyma && surface.mesh.triangle_count() > 0) return surface.mesh;
  return model.surface.mesh;
}

CommandTraits ProposeLandmarks::traits() const {
  return {.code = "propose_landmarks",
          .reads = {part::model},
          .writes = {part::proposals, part::landmarks},  // marks of later make no proposal out of date
          .needs = {part::model},
          .current = {part::model}};
}

Cancellable<Applied> ProposeLandmarks::apply(const CaseState& state, const RunContext& context) const {
  require(atlas != nullptr, "landmarks are proposed by an atlas");
  auto made = atlas::transfer(*atlas, fine_liver(state[part::model]->model), evidence(state), context);
  if (!made) return {};
  CaseState after = settled(state, std::move(*made));
  const atlas::Transfer& all = *after[part::proposals];
  return Applied{after, figures_of(all), all.doubts};
}

}  // namespace glisson::engine
