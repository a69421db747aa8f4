// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/propose_landmarks.h"

#include "glisson/atlas/transfer.h"
#include "glisson/core/error.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {
namespace {

atlas::Evidence evidence(const PatientModel& model) {
  for (const NamedSurface& surface : model.surfaces)
    if (surface.structure == structure::kParenchyma) return atlas::evidence_of(model);
  return {{}, model.landmarks.anterior_margin};
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
          .writes = {part::proposals},
          .needs = {part::model},
          .current = {part::model}};
}

Cancellable<Applied> ProposeLandmarks::apply(const CaseState& state, const RunContext& context) const {
  require(atlas != nullptr, "landmarks are proposed by an atlas");
  const PatientModel& model = state[part::model]->model;
  auto made = atlas::transfer(*atlas, fine_liver(model), evidence(model), context);
  if (!made) return {};
  Applied applied{state, figures_of(*made), made->doubts};
  applied.state[part::proposals] = std::make_shared<const atlas::Transfer>(std::move(*made));
  return applied;
}

}  // namespace glisson::engine
